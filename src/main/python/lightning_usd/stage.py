"""Walks over a stage: nodes, cameras and lights."""

from __future__ import annotations

import math
from typing import Any

import mtlx
import skeletons
from cameras import camera, chosen_first, resolution
from choice import Choice
from hidden import HiddenParents
from layers import note_missing, open_layers
from lights import is_light, is_mesh_light, light, linked_nodes, rig, unknown_light
from materials import Materials
from meshes import Meshes, SOLIDS, solid
from output import MAX_NODES, Output, PrimError, StageError, numbers, world_matrix
from pxr import Gf, Sdf, Tf, Usd, UsdGeom, UsdLux, UsdShade, Vt
from timeline import Timeline
from values import Values
from variants import Variants

LEFT_OUT = {"BasisCurves": "curves", "NurbsCurves": "curves", "HermiteCurves": "curves", "NurbsPatch": "NURBS patches",
            "Points": "point clouds", "Volume": "volumes", "TetMesh": "tetrahedral meshes"}

def describe(source: str, choice: Choice, out: Output) -> None:
    """Writes the description of a stage."""
    kept_layers = open_layers(source, out)  # noqa: F841  layers without an owner vanish
    layer = Sdf.Layer.FindOrOpen(source)
    if layer and layer.timeCodesPerSecond == 0:
        # usd-core would never end.
        raise StageError("must have timeCodesPerSecond above 0, has 0")
    stage = Usd.Stage.Open(source)
    if not stage:
        raise StageError("cannot be read by usd-core")
    kept_files = mtlx.replace_references(stage, out)  # noqa: F841  layers without an owner vanish
    Variants(stage, choice.variants, out).select()
    Walk(stage, choice, out).run()


class Walk:
    """One pass over a stage."""

    def __init__(self, stage: Usd.Stage, choice: Choice, out: Output) -> None:
        self.stage = stage
        self.choice = choice
        self.out = out
        self.nodes: list[dict[str, Any]] = []
        self.moving: list[tuple[dict[str, Any], Usd.Prim]] = []
        self.timeline = Timeline(stage, choice.frame, out)
        self.time = self.timeline.time
        self.hidden = HiddenParents(self.time)
        self.materials = Materials(out, self.time)
        self.meshes = Meshes(out, self.time)
        # Lights; those that a point instancer places with their transform to the world and whether they are hidden.
        self.lights: list[tuple[Usd.Prim, tuple[Gf.Matrix4d, bool] | None]] = []
        self.cameras: list[Usd.Prim] = []
        self.prototypes: dict[Sdf.Path, int] = {}
        # Nodes of the meshes that are lights; those of prototypes are none.
        self.mesh_lights: dict[Sdf.Path, int] = {}
        self.is_in_prototype = False
        self.prototype_lights: dict[Sdf.Path, list[tuple[Usd.Prim, Gf.Matrix4d, bool]]] = {}

    def run(self) -> None:
        """Writes the description."""
        skeletons.bake(self.stage, self.timeline.pose, self.out)
        self.walk(self.stage.GetPseudoRoot(), -1, False)
        found = chosen_first(self.stage, self.cameras, self.choice.camera, self.out)
        cameras = found[:1]
        frames = self.timeline.frames(cameras + [prim for prim, _ in self.lights])
        self.out.note("animations of additional cameras", sum(self.timeline.is_moving(prim) for prim in found[1:]) if frames else 0)
        first_shift = frames[2] if frames else 0
        for node, prim in self.moving if frames else []:
            self.attempt(prim, lambda: self.timeline.sample_node(node, prim, frames))
        document = {
            "version": 1,
            "up": str(UsdGeom.GetStageUpAxis(self.stage)),
            "meters": self.meters(),
            "frames": None if not frames else [frames[0] - first_shift, frames[1] - first_shift, self.timeline.rate()],
            "shift": first_shift,
            "resolution": resolution(self.stage),
            "cameras": self.described(cameras, lambda prim: self.timeline.over_time(prim, prim, camera, frames)),
            "other_cameras": self.described(found[1:], lambda prim: self.timeline.over_time(prim, prim, camera, None)),
            "lights": [found for prim, place in self.lights
                       if (found := self.attempt(prim, lambda: self.describe_light(prim, place, frames))) is not None],
            "nodes": self.nodes,
            "meshes": self.meshes.all,
            "materials": self.materials.all,
            "hidden": list(self.hidden.all.values()),
        }
        note_missing(self.stage, self.out)
        self.out.write(document)

    def walk(self, root: Usd.Prim, parent: int, is_prototype: bool) -> int:
        """Adds the nodes of a prim and all below; returns the index of the first, -1 if there are none."""
        first = len(self.nodes)
        stack = [parent]
        # Prototypes may be classes or overs, which keeps them out of the stage itself.
        is_plain = root.IsPseudoRoot() or root.IsDefined() and not root.IsAbstract()
        kinds = Usd.PrimDefaultPredicate if is_plain else Usd.PrimIsActive & Usd.PrimIsLoaded
        walk = iter(Usd.PrimRange.PreAndPostVisit(root, Usd.TraverseInstanceProxies(kinds)))
        for prim in walk:
            if walk.IsPostVisit():
                stack.pop()
                continue
            if prim.IsPseudoRoot():
                stack.append(-1)
                continue
            if prim.IsA(UsdShade.Material) or prim.IsA(UsdShade.Shader) or prim.IsA(UsdShade.NodeGraph) or prim.IsA(UsdGeom.Subset):
                stack.append(stack[-1])
                walk.PruneChildren()
                continue
            if len(self.nodes) >= MAX_NODES:
                raise StageError(f"has more than {MAX_NODES} prims")
            index = self.add(prim, stack[-1], is_prototype and prim == root)
            if prim.IsA(UsdGeom.PointInstancer):
                walk.PruneChildren()
            stack.append(index)
        return first if len(self.nodes) > first else -1

    def add(self, prim: Usd.Prim, parent: int, is_prototype: bool) -> int:
        """Adds the node of one prim."""
        node: dict[str, Any] = {"name": prim.GetName(), "path": str(prim.GetPath()), "parent": parent}
        index = len(self.nodes)
        self.nodes.append(node)
        xform = UsdGeom.Xformable(prim)
        if xform and not is_prototype:
            try:
                matrix = numbers(xform.GetLocalTransformation(self.time))
            except Tf.ErrorException:
                self.out.note_prim(prim, "its transform has values of another type, imported without it")
                matrix = numbers(Gf.Matrix4d(1))
            if all(map(math.isfinite, matrix)):
                node["matrix"] = matrix
            else:
                self.out.note_prim(prim, "its transform has infinite or missing numbers, imported without it")
            if xform.GetResetXformStack():
                node["parent"] = -1
            if xform.TransformMightBeTimeVarying():
                self.moving.append((node, prim))
                self.timeline.times.update(xform.GetTimeSamples())
        imageable = UsdGeom.Imageable(prim)
        if imageable:
            visibility = imageable.GetVisibilityAttr()
            node["hidden"] = visibility.Get(self.time) == UsdGeom.Tokens.invisible
            if visibility.ValueMightBeTimeVarying():
                self.timeline.times.update(visibility.GetTimeSamples())
                self.moving.append((node, prim)) if not self.moving or self.moving[-1][0] is not node else None
        if is_light(prim):
            self.lights.append((prim, None))
        elif unknown_light(prim):
            self.out.note_prim(prim, f"is a light of the unknown type {prim.GetTypeName() or 'LightAPI'}, left out")
        elif prim.IsA(UsdGeom.Camera):
            self.cameras.append(prim)
        elif prim.IsA(UsdGeom.PointInstancer):
            self.attempt(prim, lambda: self.add_instances(node, prim))
        elif prim.IsA(UsdGeom.Gprim):
            self.attempt(prim, lambda: self.add_geometry(node, prim))
        if is_mesh_light(prim) and "mesh" in node and not self.is_in_prototype:
            self.mesh_lights[prim.GetPath()] = index
            self.lights.append((prim, None))
        elif prim.HasAPI(UsdLux.MeshLightAPI):
            self.out.note("lights of point instancers or without a mesh, whose surface was to shine")
        return index

    def attempt(self, prim: Usd.Prim, function: Any) -> Any:
        """Returns what a function says of a prim; None, with a note, if it has values that nobody expects."""
        try:
            return function()
        except (StageError, MemoryError, OSError):
            raise
        except PrimError as error:
            self.out.note_prim(prim, str(error))
            return None
        except RecursionError:
            self.out.note_prim(prim, "has too many others inside each other, left out")
            return None
        except Exception:  # usd-core raises its own kinds for damaged content
            self.out.note_prim(prim, "has values of another type, left out")
            return None

    def add_geometry(self, node: dict[str, Any], prim: Usd.Prim) -> None:
        """Adds a mesh or a simple solid."""
        kind = prim.GetTypeName()
        purpose = UsdGeom.Imageable(prim).ComputePurpose()
        if purpose in (UsdGeom.Tokens.guide, UsdGeom.Tokens.proxy):
            self.out.note(f"objects of purpose {purpose}")
            return
        if purpose == UsdGeom.Tokens.render and self.hides_render(prim):
            node["hidden"] = True
        if prim.IsA(UsdGeom.Mesh):
            material = self.materials.of(prim)
            mesh = self.meshes.of(UsdGeom.Mesh(prim), self.materials, material)
            if mesh >= 0:
                node["mesh"] = mesh
                node["material"] = material if material >= 0 else self.materials.display(prim)
                node["subsets"] = self.materials.subsets(prim)
        elif kind == "Cube":
            node["mesh"] = self.meshes.cube(prim)
            material = self.materials.of(prim)
            node["material"] = material if material >= 0 else self.materials.display(prim)
        elif kind in SOLIDS:
            node["solid"] = solid(prim, self.time, self.out)
            material = self.materials.of(prim)
            node["material"] = material if material >= 0 else self.materials.display(prim)
        else:
            self.out.note(LEFT_OUT.get(kind, f"objects of type {kind}"))

    def hides_render(self, prim: Usd.Prim) -> bool:
        """Returns whether a prim of purpose render is hidden because of its purpose."""
        return UsdGeom.Imageable(prim).ComputeEffectiveVisibility(UsdGeom.Tokens.render, self.time) == UsdGeom.Tokens.invisible

    def add_instances(self, node: dict[str, Any], prim: Usd.Prim) -> None:
        """Adds the instances of a point instancer."""
        instancer = UsdGeom.PointInstancer(prim)
        targets = instancer.GetPrototypesRel().GetForwardedTargets()
        indices = instancer.GetProtoIndicesAttr().Get(self.time)
        if not targets or not indices:
            return
        # The base time of velocities is the time itself; an unset default time has none.
        time = self.time if self.time.IsNumeric() and not self.time.IsEarliestTime() else Usd.TimeCode(0)
        matrices = instancer.ComputeInstanceTransformsAtTime(time, time, applyMask=UsdGeom.PointInstancer.IgnoreMask)
        mask = instancer.ComputeMaskAtTime(self.time)
        if len(matrices) != len(indices):
            self.out.note("point instancers whose arrays differ in length")
            return
        if mask:
            kept = [i for i, shown in enumerate(mask) if shown]
            indices = Vt.IntArray([indices[i] for i in kept])
            matrices = Vt.Matrix4dArray([matrices[i] for i in kept])
        if len(indices) > MAX_NODES:
            raise StageError(f"has a point instancer of {len(indices)} instances, more than {MAX_NODES}")
        if any(attribute.ValueMightBeTimeVarying() for attribute in (
                instancer.GetPositionsAttr(), instancer.GetOrientationsAttr(), instancer.GetScalesAttr(), instancer.GetProtoIndicesAttr(),
                instancer.GetInvisibleIdsAttr())):
            self.out.note_moving("moving points of instancers", str(prim.GetPath()))
        roots = []
        for target in targets:
            if target not in self.prototypes:
                prototype = self.stage.GetPrimAtPath(target)
                self.prototypes[target] = -1
                if prototype and not prim.GetPath().HasPrefix(target):
                    self.prototypes[target] = self.walk_prototype(prototype)
            roots.append(self.prototypes[target])
        self.place_lights(prim, targets, indices, matrices)
        node["instances"] = {"prototypes": roots, "indices": self.out.array(indices), "matrices": self.out.array(matrices)}

    def walk_prototype(self, prototype: Usd.Prim) -> int:
        """Adds the nodes of a prototype; keeps its lights for its instances, each with its transform to the prototype."""
        count = len(self.lights)
        outer = self.is_in_prototype
        self.is_in_prototype = True
        result = self.walk(prototype, -2, True)
        self.is_in_prototype = outer
        cache = UsdGeom.XformCache(self.time)
        inverse = cache.GetLocalToWorldTransform(prototype).GetInverse()
        self.prototype_lights[prototype.GetPath()] = [
            (prim, (cache.GetLocalToWorldTransform(prim) if place is None else place[0]) * inverse,
             self.is_hidden_in(prim, prototype) if place is None else place[1]) for prim, place in self.lights[count:]]
        del self.lights[count:]
        return result

    def is_hidden_in(self, prim: Usd.Prim, prototype: Usd.Prim) -> bool:
        """Returns whether a prim is invisible in its prototype; what is above that does not count."""
        while prim and not prim.IsPseudoRoot() and prim.GetPath().HasPrefix(prototype.GetPath()):
            imageable = UsdGeom.Imageable(prim)
            if imageable and imageable.GetVisibilityAttr().Get(self.time) == UsdGeom.Tokens.invisible:
                return True
            prim = prim.GetParent()
        return False

    def place_lights(self, instancer: Usd.Prim, targets: list[Sdf.Path], indices: Vt.IntArray, matrices: Vt.Matrix4dArray) -> None:
        """Adds the lights of all prototypes at each place of an instancer."""
        found = [self.prototype_lights.get(target, []) for target in targets]
        if not any(found):
            return
        world = UsdGeom.XformCache(self.time).GetLocalToWorldTransform(instancer)
        is_hidden = UsdGeom.Imageable(instancer).ComputeVisibility(self.time) == UsdGeom.Tokens.invisible
        for index, matrix in zip(indices, matrices):
            for prim, local, hidden in found[index] if 0 <= index < len(found) else []:
                if len(self.lights) >= MAX_NODES:
                    raise StageError(f"has more than {MAX_NODES} lights")
                self.lights.append((prim, (local * matrix * world, hidden or is_hidden)))

    def meters(self) -> float:
        """Returns the meters of a unit; some programs write a number of less precision, which usd-core does not take."""
        try:
            return float(UsdGeom.GetStageMetersPerUnit(self.stage))
        except Exception:  # usd-core raises its own kinds
            found = self.stage.GetPseudoRoot().GetMetadata("metersPerUnit")
            return self.out.number(self.stage.GetPseudoRoot(), "metersPerUnit", found, 0.01)

    def described(self, prims: list[Usd.Prim], function: Any) -> list[dict[str, Any]]:
        """Returns what a function says of each prim that it can describe."""
        return [found for prim in prims if (found := self.attempt(prim, lambda: function(prim))) is not None]

    def describe_light(self, prim: Usd.Prim, place: tuple[Gf.Matrix4d, bool] | None, frames: tuple[int, int, int] | None) -> dict[str, Any]:
        """Returns a light with its links; in an instance of a point instancer as it is at the first frame."""
        result = self.timeline.over_time(prim, Values(prim), light, frames if place is None else None)
        result["rig"] = {**rig(prim, self.time), **(self.hidden.of(prim) if place is None else {})}
        if self.choice.frame is not None:
            result["rig"]["animated"] = [attribute.GetName() for attribute in prim.GetAuthoredAttributes() if attribute.ValueMightBeTimeVarying()]
        if place is not None:
            result["matrix"] = world_matrix(place[0])
            result["hidden"] = place[1]
            result["rig"]["shared"] = True
        if prim.GetPath() in self.mesh_lights:
            result["node"] = self.mesh_lights[prim.GetPath()]
            result["bound"] = bool(UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()[0])
        result["links"] = linked_nodes(prim, self.nodes, self.out)
        return result
