"""Lights that are hidden by a prim above them: what a layer must say so that only the light shows."""

from __future__ import annotations

from typing import Any

from pxr import Sdf, Usd, UsdGeom

MAX_CHILDREN = 1000


class HiddenParents:
    """Prims above hidden lights, from the outermost invisible one on, with the prims below that a layer can hide one by one."""

    def __init__(self, time: Usd.TimeCode) -> None:
        self.time = time
        self.all: dict[Sdf.Path, dict[str, Any]] = {}

    def of(self, prim: Usd.Prim) -> dict[str, Any]:
        """Returns the paths of such prims above a light, the outermost first, and whether one of them is hidden at some times only."""
        above = []
        outer = prim.GetParent()
        while outer and not outer.IsPseudoRoot():
            if UsdGeom.Imageable(outer):
                above.insert(0, outer)
            outer = outer.GetParent()
        first = next((i for i, parent in enumerate(above) if self.is_hidden(parent)), len(above))
        for parent in above[first:]:
            if parent.GetPath() not in self.all:
                self.all[parent.GetPath()] = self.describe(parent)
        return {"hiders": [str(parent.GetPath()) for parent in above[first:]],
                "switched": any(UsdGeom.Imageable(parent).GetVisibilityAttr().ValueMightBeTimeVarying() for parent in above)}

    def is_hidden(self, prim: Usd.Prim) -> bool:
        """Returns whether a prim itself is invisible."""
        return UsdGeom.Imageable(prim).GetVisibilityAttr().Get(self.time) == UsdGeom.Tokens.invisible

    def describe(self, parent: Usd.Prim) -> dict[str, Any]:
        """Returns a prim with the outermost prims below that can be hidden and are not; without these if they are too many."""
        result: dict[str, Any] = {"path": str(parent.GetPath()), "hidden": self.is_hidden(parent)}
        children: list[str] = []
        pending = [parent]
        while pending:
            for child in pending.pop().GetFilteredChildren(Usd.TraverseInstanceProxies(Usd.PrimDefaultPredicate)):
                if not UsdGeom.Imageable(child):
                    pending.append(child)
                elif not child.IsA(UsdGeom.Camera) and not self.is_hidden(child):
                    children.append(str(child.GetPath().MakeRelativePath(parent.GetPath())))
                if len(children) + len(pending) > MAX_CHILDREN:
                    return result
        result["children"] = sorted(children)
        return result
