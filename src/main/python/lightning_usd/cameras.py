"""Cameras."""

from __future__ import annotations

import math
from typing import Any

from choice import listed
from output import Output, StageError, world_matrix
from pxr import Usd, UsdGeom, UsdRender


def chosen_first(stage: Usd.Stage, cameras: list[Usd.Prim], name: str, out: Output) -> list[Usd.Prim]:
    """Returns all cameras, first that of a name or path; without one that of the render settings, or the first."""
    paths = [str(prim.GetPath()) for prim in cameras]
    if name:
        found = [prim for prim in cameras if name in (prim.GetName(), str(prim.GetPath()))]
        if len(found) != 1:
            amount = "the" if not found else "only one"
            raise StageError(f"must have {amount} camera '{name}', has {listed([str(prim.GetPath()) for prim in found] or paths) or 'none'}")
    else:
        settings = UsdRender.Settings.GetStageRenderSettings(stage)
        targets = settings.GetCameraRel().GetForwardedTargets() if settings else []
        found = [prim for prim in cameras if prim.GetPath() in targets] or cameras
        if targets and targets[0] not in [prim.GetPath() for prim in found]:
            out.note(f"cameras of render settings that the stage does not have: {targets[0]}")
    return found[:1] + [prim for prim in cameras if prim != found[0]]


def resolution(stage: Usd.Stage) -> list[int] | None:
    """Returns the width and height of the picture by the render settings; None if they say none."""
    settings = UsdRender.Settings.GetStageRenderSettings(stage)
    size = settings.GetResolutionAttr().Get() if settings and settings.GetResolutionAttr().HasAuthoredValue() else None
    return [int(size[0]), int(size[1])] if size and size[0] > 0 and size[1] > 0 else None


def camera(prim: Usd.Prim, time: Usd.TimeCode, out: Output) -> dict[str, Any]:
    """Returns a camera at a time."""
    view = UsdGeom.Camera(prim)
    scale = view.ComputeLinearExposureScale(time) if hasattr(view, "ComputeLinearExposureScale") else 2.0 ** (view.GetExposureAttr().Get(time) or 0.0)

    def number(attribute: Usd.Attribute, fallback: float) -> float:
        found = attribute.Get(time)
        return fallback if found is None else out.number(prim, attribute.GetName(), found, fallback)

    return {
        "matrix": world_matrix(UsdGeom.XformCache(time).GetLocalToWorldTransform(prim)),
        "orthographic": view.GetProjectionAttr().Get(time) == UsdGeom.Tokens.orthographic,
        "focal": number(view.GetFocalLengthAttr(), 50.0),
        "width": number(view.GetHorizontalApertureAttr(), 20.955),
        "height": number(view.GetVerticalApertureAttr(), 15.2908),
        "offset_x": number(view.GetHorizontalApertureOffsetAttr(), 0.0),
        "offset_y": number(view.GetVerticalApertureOffsetAttr(), 0.0),
        "exposure": math.log2(scale) if 0 < scale < math.inf else 0.0,
        "focus": number(view.GetFocusDistanceAttr(), 0.0),
        "f_number": number(view.GetFStopAttr(), 0.0),
    }
