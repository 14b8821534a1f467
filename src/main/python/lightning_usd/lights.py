"""Lights of UsdLux."""

from __future__ import annotations

import math
from typing import Any

from output import Output, numbers, world_matrix
from pxr import Gf, Usd, UsdGeom, UsdLux
from values import Values

KINDS = {"DistantLight", "SphereLight", "DiskLight", "RectLight", "CylinderLight", "DomeLight", "DomeLight_1"}
INPUTS = {"intensity": 1.0, "exposure": 0.0, "normalize": False, "diffuse": 1.0, "specular": 1.0, "angle": 0.53, "radius": 0.5,
          "width": 1.0, "height": 1.0, "length": 1.0}


def is_mesh_light(prim: Usd.Prim) -> bool:
    """Returns whether the surface of a mesh is a light."""
    return prim.HasAPI(UsdLux.MeshLightAPI) and prim.IsA(UsdGeom.Mesh)


def is_light(prim: Usd.Prim) -> bool:
    """Returns whether a prim is a light of a type of its own."""
    return prim.GetTypeName() in KINDS or prim.IsA(UsdLux.NonboundableLightBase) or prim.IsA(UsdLux.BoundableLightBase)


def unknown_light(prim: Usd.Prim) -> bool:
    """Returns whether a prim is a light of a type that only another renderer knows, or that its plugin defines."""
    if prim.HasAPI(UsdLux.MeshLightAPI) or prim.HasAPI(UsdLux.VolumeLightAPI) or prim.IsA(UsdGeom.Gprim):
        return False
    return str(prim.GetTypeName()).endswith("Light") or prim.HasAPI(UsdLux.LightAPI)


def number(values: Values, name: str, time: Usd.TimeCode, fallback: float, out: Output) -> float:
    """Returns the number of an attribute."""
    return out.number(values.prim, name, values.get(name, time, fallback), fallback)


def light(values: Values, time: Usd.TimeCode, out: Output) -> dict[str, Any]:
    """Returns a light at a time."""
    prim = values.prim
    kind = prim.GetTypeName()
    result: dict[str, Any] = {"type": "MeshLight" if is_mesh_light(prim) else str(kind), "matrix": world_matrix(UsdGeom.XformCache(time).GetLocalToWorldTransform(prim))}
    for name, fallback in INPUTS.items():
        found = values.get("inputs:" + name, time, fallback)
        result[name] = bool(found) if isinstance(fallback, bool) else out.number(prim, "inputs:" + name, found, fallback)
    result["color"] = out.vector(prim, "inputs:color", values.get("inputs:color", time, (1, 1, 1)), [1.0] * 3)
    if values.get("inputs:enableColorTemperature", time, False):
        result["temperature"] = number(values, "inputs:colorTemperature", time, 6500.0, out)
    result["treatAsPoint"] = bool(values.get("treatAsPoint", time, False))
    result["treatAsLine"] = bool(values.get("treatAsLine", time, False))
    result["hidden"] = UsdGeom.Imageable(prim).ComputeVisibility(time) == UsdGeom.Tokens.invisible
    result["shadows"] = bool(values.get("inputs:shadow:enable", time, True))
    result["pole"] = str(values.get("poleAxis", time, "scene")) if kind == "DomeLight_1" else "Y"
    texture = values.get("inputs:texture:file", time, None)
    if texture and getattr(texture, "path", ""):
        result["texture"] = out.file(texture)
        result["format"] = str(values.get("inputs:texture:format", time, "automatic"))
    if prim.HasAPI(UsdLux.ShapingAPI) or prim.GetAttribute("inputs:shaping:cone:angle").HasAuthoredValue():
        result["shaping"] = shaping(values, time, out)
    if prim.GetRelationship("light:filters").GetTargets():
        out.note("light filters")
    return result


def shaping(values: Values, time: Usd.TimeCode, out: Output) -> dict[str, Any]:
    """Returns the cone and the profile of a light."""
    prim = values.prim
    result: dict[str, Any] = {
        "angle": number(values, "inputs:shaping:cone:angle", time, 90.0, out),
        "softness": number(values, "inputs:shaping:cone:softness", time, 0.0, out),
        "focus": number(values, "inputs:shaping:focus", time, 0.0, out),
    }
    # Over time, a soft cone would need a profile for each frame.
    result["moves"] = any(attribute.ValueMightBeTimeVarying() for name in ("angle", "softness")
                          if (attribute := prim.GetAttribute("inputs:shaping:cone:" + name)))
    profile = values.get("inputs:shaping:ies:file", time, None)
    if profile and getattr(profile, "path", ""):
        result["profile"] = out.file(profile)
        result["angleScale"] = number(values, "inputs:shaping:ies:angleScale", time, 0.0, out)
    if any(out.vector(prim, "inputs:shaping:focusTint", values.get("inputs:shaping:focusTint", time, (0, 0, 0)), [0.0] * 3)):
        out.note("focus tints of lights")
    return result


def rig(prim: Usd.Prim, time: Usd.TimeCode) -> dict[str, Any]:
    """Returns what a layer needs that changes a light in its place: the inverse transform of its parent, its schemas and instances."""
    xform = UsdGeom.Xformable(prim)
    result: dict[str, Any] = {"apis": [str(name) for name in prim.GetAppliedSchemas()], "resets": bool(xform.GetResetXformStack()),
                              "moves": False, "instances": []}
    parent = Gf.Matrix4d(1) if result["resets"] else UsdGeom.XformCache(time).GetParentToWorldTransform(prim)
    is_below_reset = result["resets"]
    above = prim.GetParent()
    while above and not above.IsPseudoRoot():
        outer = UsdGeom.Xformable(above)
        if outer and not is_below_reset:
            result["moves"] |= bool(outer.TransformMightBeTimeVarying())
            is_below_reset = bool(outer.GetResetXformStack())
        if above.IsInstance():
            result["instances"].insert(0, str(above.GetPath()))
        above = above.GetParent()
    inverse = numbers(parent.GetInverse())
    if parent.GetDeterminant() and all(map(math.isfinite, inverse)):
        result["inverse"] = inverse
    return result


def linked_nodes(prim: Usd.Prim, nodes: list[dict[str, Any]], out: Output) -> dict[str, Any]:
    """Returns the nodes that a light is linked to: {"light": ..., "shadow": ...}, each {"only": yes or no, "nodes": [...]}."""
    api = UsdLux.LightAPI(prim)
    result = {}
    for key, collection in (("light", api.GetLightLinkCollectionAPI()), ("shadow", api.GetShadowLinkCollectionAPI())):
        includes = collection.GetIncludesRel().GetTargets()
        excludes = collection.GetExcludesRel().GetTargets()
        root = collection.GetIncludeRootAttr()
        if not includes and not excludes and root.Get() is not False:
            continue
        if not includes and not excludes and collection.GetMembershipExpressionAttr().Get():
            out.note("light links by expressions")
            continue
        result[key] = selection(collection.ComputeMembershipQuery(), nodes, root.Get() is not False)
    return result


def selection(query: Usd.CollectionMembershipQuery, nodes: list[dict[str, Any]], with_root: bool) -> dict[str, Any]:
    """Returns the list of nodes, of all that show something, that is included as a whole, or excluded if the root is included."""
    shows = [any(key in node for key in ("mesh", "solid", "instances")) for node in nodes]
    # Bits: 1 for an included object in the node, 2 for an excluded one. Children follow their parents in the list.
    state = [0] * len(nodes)
    for i in range(len(nodes) - 1, -1, -1):
        if shows[i]:
            state[i] |= 1 if query.IsPathIncluded(nodes[i]["path"]) else 2
        if nodes[i]["parent"] >= 0:
            state[nodes[i]["parent"]] |= state[i]
    own = [i for i, node in enumerate(nodes) if node["parent"] != -2]
    def tops(wanted: int) -> list[int]:
        return [i for i in own if state[i] == wanted and (nodes[i]["parent"] < 0 or state[nodes[i]["parent"]] != wanted)]
    return {"only": not with_root, "nodes": tops(2 if with_root else 1)}
