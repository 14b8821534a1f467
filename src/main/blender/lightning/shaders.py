# SPDX-License-Identifier: Apache-2.0
"""Shaders of materials, and which of them are not sent exactly."""

import bpy

from . import materials, model
from .left_out import listed

# Shaders that are exported as they are if they are all of a surface.
EXPORTED = {"ShaderNodeBsdfPrincipled", "ShaderNodeBsdfGlass", "ShaderNodeBsdfRefraction"}
# Sockets of a Principled BSDF for what no material of Lightning has.
MISSING = {"Subsurface Weight": "subsurface scattering, sent as diffuse",
           "Thin Film Thickness": "thin films"}
# Sockets whose textures are left out.
ANISOTROPY = ("Anisotropic", "Anisotropic Rotation")


def is_exported(kinds: dict[str, str]) -> bool:
    """Returns whether Blender's exporter writes a surface with these shaders."""
    return len(kinds) == 1 and kinds.keys() <= EXPORTED


def notes(root: dict, lost: dict[str, str]) -> list[str]:
    """Returns messages that name the materials whose shaders are not sent exactly, with what they lose, and those with displacement.

    Args:
        lost: what the materials with other shaders lose
    """
    inexact = {}
    displaced = []
    for entry in root.get("materials", []):
        material = bpy.data.materials.get(entry.get("name", ""))
        if material is None or material.node_tree is None:
            continue
        others = lost.get(material.name, "")
        losses = ", ".join([*filter(None, [others]), *(title for title in _missing(material) if title not in others)])
        if losses:
            inexact[material.name] = f"{material.name} ({losses})"
        if materials.linked(material, "Displacement") is not None:
            displaced.append(material.name)
    messages = [f"shaders are not sent exactly: {listed(list(inexact.values()))}"] if inexact else []
    return messages + ([f"displacement is not sent: {listed(displaced)}"] if displaced else [])


def _missing(material) -> list[str]:
    node = model.principled(material)
    if node is None:
        return []
    found = [title for name, title in MISSING.items() if node.inputs[name].is_linked or node.inputs[name].default_value != 0]
    textures = ["textures of anisotropy"] if any(node.inputs[name].is_linked for name in ANISOTROPY) else []
    textures += ["tangent of its anisotropy, which is that of the UV map"] if _has_other_tangent(material, node) else []
    return found + textures + (["colors of coats"] if _has_coat_color(node) else [])


def _has_other_tangent(material, node) -> bool:
    """Returns whether anisotropy has a direction that does not follow the UV map of an object."""
    strength, links = node.inputs["Anisotropic"], node.inputs["Tangent"].links
    if not strength.is_linked and strength.default_value == 0:
        return False
    if links and links[0].from_node.bl_idname == "ShaderNodeTangent" and links[0].from_node.direction_type == "UV_MAP":
        return False
    return bool(links) or any(o.type == "MESH" and o.data.uv_layers and material.name in o.data.materials for o in bpy.data.objects)


def _has_coat_color(node) -> bool:
    """Returns whether a coat is not clear."""
    weight, tint = node.inputs["Coat Weight"], node.inputs["Coat Tint"]
    return (weight.is_linked or weight.default_value != 0) and (tint.is_linked or any(c != 1 for c in tint.default_value[:3]))


def of_surface(material) -> dict[str, str]:
    """Returns the names of the shader nodes that a material's surface shows, by their type."""
    result: dict[str, str] = {}
    surface = materials.linked(material, "Surface")
    waiting, seen = [surface] if surface is not None else [], set()
    while waiting:
        node = waiting.pop()
        if node in seen:
            continue
        seen.add(node)
        if any(socket.type == "SHADER" for socket in node.outputs) and node.type not in ("GROUP", "REROUTE"):
            result[node.bl_idname] = node.bl_label
        if node.type == "GROUP" and node.node_tree is not None:
            waiting += [inner for inner in node.node_tree.nodes if inner.type == "GROUP_OUTPUT"]
        waiting += [link.from_node for socket in node.inputs if socket.type == "SHADER" for link in socket.links]
    return result
