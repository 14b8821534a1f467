"""Cameras."""

from __future__ import annotations

from typing import Any

from output import Output, world_matrix
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
        "focus": number(view.GetFocusDistanceAttr(), 0.0),
    }
