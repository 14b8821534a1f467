"""Meshes and simple solids."""

from __future__ import annotations

from typing import Any

from output import Output
from pxr import Sdf, Usd, UsdGeom, Vt

SOLIDS = {"Sphere", "Cylinder", "Cylinder_1", "Cone", "Capsule", "Capsule_1", "Plane"}


SIZES = {"size": 2.0, "radius": 1.0, "height": 2.0, "width": 2.0, "length": 2.0, "radiusTop": 0.5, "radiusBottom": 0.5}


def identity(prim: Usd.Prim) -> Sdf.Path:
    """Returns the same path for all instances of a prim."""
    return prim.GetPrimInPrototype().GetPath() if prim.IsInstanceProxy() else prim.GetPath()


def solid(prim: Usd.Prim, time: Usd.TimeCode, out: Output) -> dict[str, Any]:
    """Returns a simple solid, with sizes in its own space."""
    result: dict[str, Any] = {"type": str(prim.GetTypeName()).removesuffix("_1")}
    is_moving = False
    for name, fallback in SIZES.items():
        attribute = prim.GetAttribute(name)
        if attribute:
            result[name] = out.number(prim, name, attribute.Get(time), fallback)
            is_moving |= attribute.ValueMightBeTimeVarying()
    if is_moving:
        out.note_moving("objects whose size changes", str(prim.GetPath()))
    if prim.GetAttribute("axis"):
        result["axis"] = str(prim.GetAttribute("axis").Get())
    return result


def floats(values: Any, kind: Any) -> Any:
    """Returns vectors as an array of floats: old files have doubles, or other types that usd-core reads nevertheless."""
    return values if isinstance(values, kind) else kind([tuple(float(number) for number in vector) for vector in values])


class Meshes:
    """All meshes of a stage; instances share one."""

    def __init__(self, out: Output, time: Usd.TimeCode) -> None:
        self.out = out
        self.time = time
        self.all: list[dict[str, Any]] = []
        self.known: dict[tuple[Any, ...], int] = {}

    def of(self, mesh: UsdGeom.Mesh, materials: Any, material: int) -> int:
        """Returns the index of a mesh; -1 if it has no faces."""
        prim = mesh.GetPrim()
        coordinates = materials.coordinates(material)
        key = (identity(prim), coordinates, material < 0)
        if key not in self.known:
            self.known[key] = self.add(mesh, coordinates, material < 0)
        return self.known[key]

    def cube(self, prim: Usd.Prim) -> int:
        """Returns the index of a cube."""
        if prim.GetAttribute("size").ValueMightBeTimeVarying():
            self.out.note_moving("objects whose size changes", str(prim.GetPath()))
        half = self.out.number(prim, "size", prim.GetAttribute("size").Get(self.time), 2.0) / 2
        key = ("cube", half)
        if key not in self.known:
            corners = [(x, y, z) for x in (-half, half) for y in (-half, half) for z in (-half, half)]
            faces = [0, 1, 3, 2, 4, 6, 7, 5, 0, 4, 5, 1, 2, 3, 7, 6, 0, 2, 6, 4, 1, 5, 7, 3]
            self.known[key] = len(self.all)
            self.all.append({"name": "cube", "path": str(prim.GetPath()), "points": self.out.array(Vt.Vec3fArray(corners)),
                             "counts": self.out.array(Vt.IntArray([4] * 6)), "indices": self.out.array(Vt.IntArray(faces)),
                             "left": False, "smooth": False})
        return self.known[key]

    def add(self, mesh: UsdGeom.Mesh, coordinates: str, colored: bool) -> int:
        """Adds a mesh."""
        prim, out = mesh.GetPrim(), self.out
        points = mesh.GetPointsAttr().Get(self.time)
        counts = mesh.GetFaceVertexCountsAttr().Get(self.time)
        out.check_triangles(len(counts or ()))
        indices = mesh.GetFaceVertexIndicesAttr().Get(self.time)
        triangles = max(len(indices or ()) - 2 * len(counts or ()), 0)
        out.check_triangles(triangles)
        out.triangles += triangles
        if not points or not counts or not indices:
            out.note("meshes without faces")
            return -1
        try:
            points = floats(points, Vt.Vec3fArray)
        except (TypeError, ValueError):
            out.note_prim(prim, "points of another type, left out")
            return -1
        scheme = str(mesh.GetSubdivisionSchemeAttr().Get())
        result: dict[str, Any] = {
            "name": prim.GetName(), "path": str(prim.GetPath()),
            "points": out.array(points), "counts": out.array(counts), "indices": out.array(indices),
            "left": mesh.GetOrientationAttr().Get() == UsdGeom.Tokens.leftHanded,
            "smooth": scheme in ("catmullClark", "loop"),
        }
        has_normals = self.attach_normals(mesh, result)
        if scheme == "catmullClark" and (mesh.GetSubdivisionSchemeAttr().HasAuthoredValue() or not has_normals):
            result["subdivision"] = self.subdivision(mesh)
        elif scheme == "catmullClark":
            # Written by a program that did not think of the default.
            out.note("meshes with normals and without a subdivision scheme, imported as polygons")
        elif scheme == "loop":
            out.note("subdivision surfaces of scheme loop, imported as their control meshes")
        holes = mesh.GetHoleIndicesAttr().Get(self.time)
        if holes:
            result["holes"] = out.array(holes)
        self.note_motion(mesh)
        api = UsdGeom.PrimvarsAPI(prim)
        uv = self.texture_coordinates(api, coordinates)
        if uv:
            self.attach(result, "uv", uv.Get(self.time), uv.GetIndices(self.time), str(uv.GetInterpolation()), Vt.Vec2fArray)
        color = api.FindPrimvarWithInheritance("displayColor")
        if colored and color and color.HasValue() and color.GetInterpolation() != "constant":
            self.attach(result, "colors", color.Get(self.time), color.GetIndices(self.time), str(color.GetInterpolation()), Vt.Vec3fArray)
        self.all.append(result)
        return len(self.all) - 1

    def note_motion(self, mesh: UsdGeom.Mesh) -> None:
        """Notes a mesh whose shape or colors change over time."""
        path = str(mesh.GetPath())
        if any(attribute.ValueMightBeTimeVarying() for attribute in (mesh.GetPointsAttr(), mesh.GetFaceVertexIndicesAttr())):
            self.out.note_moving("deforming meshes", path)
        elif any(primvar.ValueMightBeTimeVarying() for primvar in UsdGeom.PrimvarsAPI(mesh).GetPrimvarsWithAuthoredValues()):
            self.out.note_moving("meshes whose colors, normals or texture coordinates change", path)

    def attach_normals(self, mesh: UsdGeom.Mesh, result: dict[str, Any]) -> bool:
        """Adds the normals of a mesh; returns whether it has any."""
        normals = UsdGeom.PrimvarsAPI(mesh.GetPrim()).GetPrimvar("normals")
        if normals and normals.HasAuthoredValue():
            self.attach(result, "normals", normals.Get(self.time), normals.GetIndices(self.time), str(normals.GetInterpolation()), Vt.Vec3fArray)
        elif mesh.GetNormalsAttr().HasAuthoredValue():
            self.attach(result, "normals", mesh.GetNormalsAttr().Get(self.time), None, str(mesh.GetNormalsInterpolation()), Vt.Vec3fArray)
        return "normals" in result

    def subdivision(self, mesh: UsdGeom.Mesh) -> dict[str, Any]:
        """Returns the boundary rule, creases and corners of a subdivision surface."""
        result: dict[str, Any] = {"boundary": str(mesh.GetInterpolateBoundaryAttr().Get(self.time))}
        for name, attribute in (("creaseIndices", mesh.GetCreaseIndicesAttr()), ("creaseLengths", mesh.GetCreaseLengthsAttr()),
                                ("creaseSharpnesses", mesh.GetCreaseSharpnessesAttr()), ("cornerIndices", mesh.GetCornerIndicesAttr()),
                                ("cornerSharpnesses", mesh.GetCornerSharpnessesAttr())):
            values = attribute.Get(self.time)
            if values:
                result[name] = self.out.array(values)
        if mesh.GetTriangleSubdivisionRuleAttr().Get(self.time) == "smooth":
            self.out.note("subdivision surfaces with the smooth rule for triangles, refined with the usual one")
        return result

    def attach(self, result: dict[str, Any], name: str, values: Any, indices: Any, interpolation: str, kind: Any) -> None:
        """Adds values of vertices or faces."""
        if not values:
            return
        try:
            entry = {"values": self.out.array(floats(values, kind)), "interpolation": interpolation}
        except (TypeError, ValueError, RuntimeError):
            self.out.note(f"{result['path']}: {name} of another type, left out")
            return
        if indices:
            entry["indices"] = self.out.array(indices)
        result[name] = entry

    @staticmethod
    def texture_coordinates(api: UsdGeom.PrimvarsAPI, wanted: str) -> Any:
        """Returns the primvar of texture coordinates: the wanted one, a usual one, or any."""
        for name in (wanted, "st", "UVMap", "uv", "st0", "map1"):
            primvar = api.FindPrimvarWithInheritance(name) if name else None
            if primvar and primvar.HasValue():
                return primvar
        return next((p for p in api.GetPrimvarsWithValues() if p.GetTypeName() == Sdf.ValueTypeNames.TexCoord2fArray), None)
