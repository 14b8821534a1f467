"""Instances, whose prims cannot be edited."""

from __future__ import annotations

from typing import Iterable

from pxr import Sdf, Usd

MAX_DEPTH = 32


def outermost_instance(prim: Usd.Prim) -> Usd.Prim | None:
    """Returns the instance that a prim is or is inside of; None without one."""
    found = None
    while prim and not prim.IsPseudoRoot():
        found = prim if prim.IsInstance() else found
        prim = prim.GetParent()
    return found


def dissolve(stage: Usd.Stage, prims: Iterable[Usd.Prim]) -> bool:
    """Makes prims editable that are in instances, in memory only; returns whether there were any."""
    instances: set[Sdf.Path] = {instance.GetPath() for prim in prims for instance in [outermost_instance(prim)] if instance}
    stage.SetEditTarget(stage.GetSessionLayer())
    for path in instances:
        stage.GetPrimAtPath(path).SetInstanceable(False)
    return bool(instances)
