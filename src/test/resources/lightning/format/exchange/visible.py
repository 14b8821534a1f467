"""Prints the paths of all visible prims of a stage: `visible.py stage.usda`."""

import sys

from pxr import Usd, UsdGeom

stage = Usd.Stage.Open(sys.argv[1])
for prim in Usd.PrimRange(stage.GetPseudoRoot(), Usd.TraverseInstanceProxies()):
    if UsdGeom.Imageable(prim) and UsdGeom.Imageable(prim).ComputeVisibility() != UsdGeom.Tokens.invisible:
        print(prim.GetPath())
