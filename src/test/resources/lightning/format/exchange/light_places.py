"""Prints where the lights of a stage are: `light_places.py shot.usda`."""

import sys

from pxr import Gf, Usd, UsdGeom, UsdLux

stage = Usd.Stage.Open(sys.argv[1])
cache = UsdGeom.XformCache(Usd.TimeCode(1))


def text(vector):
    """Returns numbers without rounding errors."""
    return " ".join(f"{round(v, 6) + 0.0:g}" for v in vector)


for prim in Usd.PrimRange.Stage(stage, Usd.TraverseInstanceProxies()):
    if prim.HasAPI(UsdLux.LightAPI):
        matrix = cache.GetLocalToWorldTransform(prim)
        rows = [Gf.Vec3d(*list(matrix.GetRow(i))[:3]) for i in range(4)]
        print(prim.GetPath(), "at", text(rows[3]), "shines", text(-rows[2].GetNormalized()), "scale", text(r.GetLength() for r in rows[:3]))
