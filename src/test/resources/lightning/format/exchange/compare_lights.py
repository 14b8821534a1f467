"""Prints how the lights of two stages differ: `compare_lights.py original composed`."""

import math
import sys

from pxr import Gf, Usd, UsdGeom, UsdLux

one, other = (Usd.Stage.Open(path) for path in sys.argv[1:3])
PATHS = [prim.GetPath() for prim in one.Traverse()]
TURNS = {"SphereLight": "", "DiskLight": "z", "DistantLight": "z", "RectLight": "xyz", "CylinderLight": "x", "DomeLight": "xyz"}


def members(collection):
    """Returns the paths of all members."""
    query = collection.ComputeMembershipQuery()
    return {path for path in PATHS if query.IsPathIncluded(path)}


def axes(original, prim, time):
    """Returns what of a light's place can be seen: its rotation only where the original is not round."""
    matrix = UsdGeom.XformCache(time).GetLocalToWorldTransform(prim)
    turns = "z" if original.HasAPI(UsdLux.ShapingAPI) and original.GetTypeName() == "SphereLight" else TURNS[original.GetTypeName()]
    rows = [matrix.GetRow(i) for i, name in enumerate("xyz") if name in turns]
    return rows + ([] if prim.GetTypeName() in ("DistantLight", "DomeLight") else [matrix.GetRow(3)])


count = 0
for prim in one.Traverse():
    if not prim.HasAPI(UsdLux.LightAPI):
        continue
    count += 1
    twin = other.GetPrimAtPath(prim.GetPath())
    if twin.GetTypeName() != prim.GetTypeName():
        print(prim.GetPath(), "has type", twin.GetTypeName())
    for time in (1, 6, 12, 20, 24):
        for attribute in prim.GetAuthoredAttributes():
            name = attribute.GetName()
            if name.startswith("xformOp") or name.startswith("collection"):
                continue
            before, after = attribute.Get(time), twin.GetAttribute(name).Get(time)
            if isinstance(before, float):
                same = math.isclose(before, after, rel_tol=1e-6)
            else:
                same = getattr(before, "resolvedPath", before) == getattr(after, "resolvedPath", after)
            if not same:
                print(prim.GetPath(), name, "at", time, "was", before, "is", after)
        for before, after in zip(axes(prim, prim, Usd.TimeCode(time)), axes(prim, twin, Usd.TimeCode(time))):
            if not Gf.IsClose(before, after, 1e-8):
                print(prim.GetPath(), "at", time, "was at", before, "is at", after)
    for name in ("GetLightLinkCollectionAPI", "GetShadowLinkCollectionAPI"):
        if members(getattr(UsdLux.LightAPI(prim), name)()) != members(getattr(UsdLux.LightAPI(twin), name)()):
            print(prim.GetPath(), name, "differs")
print(count, "lights")
