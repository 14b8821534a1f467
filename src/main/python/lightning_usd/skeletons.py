"""Skeletons: skinned meshes in the pose of one frame."""

from __future__ import annotations

from instances import MAX_DEPTH, dissolve
from output import Output
from pxr import Gf, Usd, UsdSkel


def bake(stage: Usd.Stage, time: float, out: Output) -> None:
    """Puts skinned meshes into their pose at a time, in memory only."""
    stage.SetEditTarget(stage.GetSessionLayer())
    for root in skeleton_roots(stage):
        if not root:
            # Posed already, with a root that this one references.
            continue
        try:
            moving = moving_attributes(root)
            if moving:
                out.note_moving("moving skeletons, with meshes posed", str(root.GetPath()))
            for attribute in moving:
                # usd-core poses meshes only at times of samples.
                attribute.Set(attribute.Get(time), time)
            if not UsdSkel.BakeSkinning(root, Gf.Interval(time, time)):
                out.note("skeletons that cannot be evaluated")
        except Exception:
            out.note("skeletons that cannot be evaluated")


def skeleton_roots(stage: Usd.Stage) -> list[UsdSkel.Root]:
    """Returns all roots of skeletons; instances with one are dissolved, since each may have its own pose."""
    roots: list[Usd.Prim] = []
    for _ in range(MAX_DEPTH):
        everything = Usd.PrimRange.Stage(stage, Usd.TraverseInstanceProxies(Usd.PrimDefaultPredicate))
        roots = [prim for prim in everything if prim.IsA(UsdSkel.Root)]
        if not dissolve(stage, roots):
            break
    return [UsdSkel.Root(prim) for prim in roots if not prim.IsInstanceProxy()]


def moving_attributes(root: UsdSkel.Root) -> list[Usd.Attribute]:
    """Returns the attributes that move the skeletons below a root, or change the shape of their meshes, over time."""
    cache = UsdSkel.Cache()
    cache.Populate(root, Usd.PrimDefaultPredicate)
    queries = [cache.GetSkelQuery(binding.GetSkeleton()).GetAnimQuery() for binding in cache.ComputeSkelBindings(root, Usd.PrimDefaultPredicate)]
    animations = [UsdSkel.Animation(query.GetPrim()) for query in queries if query]
    return [attribute for animation in animations for attribute in (
        animation.GetRotationsAttr(), animation.GetTranslationsAttr(), animation.GetScalesAttr(), animation.GetBlendShapeWeightsAttr())
        if attribute.ValueMightBeTimeVarying()]
