"""Cameras."""

from __future__ import annotations

from typing import Any

from output import Output, numbers
from pxr import Usd, UsdGeom, UsdRender


def chosen_camera(stage: Usd.Stage, cameras: list[Usd.Prim]) -> Usd.Prim:
    """Returns the camera of the render settings, or the first."""
    settings = UsdRender.Settings.GetStageRenderSettings(stage)
    targets = settings.GetCameraRel().GetForwardedTargets() if settings else []
    return next((prim for prim in cameras if prim.GetPath() in targets), cameras[0])


def camera(prim: Usd.Prim, time: Usd.TimeCode, out: Output) -> dict[str, Any]:
    """Returns a camera at a time."""
    view = UsdGeom.Camera(prim)
    if view.GetFStopAttr().Get(time):
        out.note("depth of field of cameras")
    return {
        "matrix": numbers(UsdGeom.XformCache(time).GetLocalToWorldTransform(prim)),
        "orthographic": view.GetProjectionAttr().Get(time) == UsdGeom.Tokens.orthographic,
        "focal": view.GetFocalLengthAttr().Get(time),
        "width": view.GetHorizontalApertureAttr().Get(time),
        "height": view.GetVerticalApertureAttr().Get(time),
        "offset_x": view.GetHorizontalApertureOffsetAttr().Get(time),
        "offset_y": view.GetVerticalApertureOffsetAttr().Get(time),
        "focus": view.GetFocusDistanceAttr().Get(time),
    }
