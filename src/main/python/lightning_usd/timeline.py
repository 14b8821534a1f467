"""Times of a stage: the one that is shown, and those at which it moves."""

from __future__ import annotations

import math
from typing import Any

from output import MAX_FRAMES, Output, numbers
from pxr import Usd, UsdGeom, Vt


class Timeline:
    """Times of a stage."""

    def __init__(self, stage: Usd.Stage, chosen: float | None, out: Output) -> None:
        """Creates a timeline.

        Args:
            chosen: time code of the only frame; None for all
        """
        self.stage = stage
        self.chosen = chosen
        self.out = out
        # Times of samples of all that moves.
        self.times: set[float] = set()
        self.has_range = stage.HasAuthoredTimeCodeRange() and stage.GetEndTimeCode() >= stage.GetStartTimeCode()
        start = stage.GetStartTimeCode() if chosen is None else chosen
        is_known = self.has_range or chosen is not None
        self.time = Usd.TimeCode(start) if is_known else Usd.TimeCode.EarliestTime()
        self.pose = start if is_known else 0.0
        if chosen is None:
            out.shown_frame = f"as at the first frame ({start:.10g})" if self.has_range else "as at the first frame"

    def frames(self, prims: list[Usd.Prim]) -> tuple[int, int, int] | None:
        """Returns the first and last time of all that moves, and what is taken off for the number of a frame; None for one frame.

        Args:
            prims: prims whose attributes may move; the times of others are in `times`
        """
        if self.chosen is not None:
            self.note_range(self.chosen)
            return None
        moves = bool(self.times)
        for prim in prims:
            moves |= self.is_moving(prim)
        if not moves:
            return None
        start, end = min(self.times, default=0.0), max(self.times, default=0.0)
        if self.has_range:
            start, end = self.stage.GetStartTimeCode(), self.stage.GetEndTimeCode()
        if not (abs(start) < 1e8 and abs(end) < 1e8):
            self.out.note("animation beyond frame 100000000")
            return None
        first, last = math.floor(start), math.ceil(end)
        self.out.note(f"frames after the first {MAX_FRAMES}", max(0, last - first + 1 - MAX_FRAMES))
        self.out.note("frames before 0, all moved", 1 if first < 0 else 0)
        return first, min(last, first + MAX_FRAMES - 1), min(first, 0)

    def note_range(self, frame: float) -> None:
        """Notes a frame that the stage does not have."""
        start, end = self.stage.GetStartTimeCode(), self.stage.GetEndTimeCode()
        if self.has_range and not start <= frame <= end:
            self.out.note(f"frames outside of the stage's {start:.10g} to {end:.10g}")

    def is_moving(self, prim: Usd.Prim) -> bool:
        """Returns whether an attribute of a prim, or the transform or visibility of one above it, has time samples. Collects their times."""
        samples: set[float] = set()
        for attribute in prim.GetAuthoredAttributes():
            samples.update(attribute.GetTimeSamples())
        while prim and not prim.IsPseudoRoot():
            xform, imageable = UsdGeom.Xformable(prim), UsdGeom.Imageable(prim)
            if xform:
                samples.update(xform.GetTimeSamples())
            if imageable:
                samples.update(imageable.GetVisibilityAttr().GetTimeSamples())
            prim = prim.GetParent()
        self.times.update(samples)
        return len(samples) > 1

    def rate(self) -> float:
        """Returns the frames per second."""
        return self.out.number(self.stage.GetPseudoRoot(), "timeCodesPerSecond", self.stage.GetTimeCodesPerSecond(), 24.0)

    def sample_node(self, node: dict[str, Any], prim: Usd.Prim, frames: tuple[int, int, int]) -> None:
        """Adds the transforms and the visibility at all frames."""
        xform = UsdGeom.Xformable(prim)
        times = range(frames[0], frames[1] + 1)
        if xform and xform.TransformMightBeTimeVarying():
            matrices = [xform.GetLocalTransformation(float(time)) for time in times]
            if all(math.isfinite(number) for matrix in matrices for number in numbers(matrix)):
                node["matrices"] = self.out.array(Vt.Matrix4dArray(matrices))
            else:
                self.out.note_prim(prim, "its animation has infinite or missing numbers, imported without it")
        visibility = UsdGeom.Imageable(prim).GetVisibilityAttr()
        if visibility.ValueMightBeTimeVarying():
            node["hiddenAt"] = [visibility.Get(float(time)) == UsdGeom.Tokens.invisible for time in times]

    def over_time(self, prim: Usd.Prim, subject: Any, function: Any, frames: tuple[int, int, int] | None) -> dict[str, Any]:
        """Returns what a function says of a prim, with all frames if it moves."""
        result = function(subject, self.time, self.out)
        result["name"] = prim.GetName()
        result["path"] = str(prim.GetPath())
        result["proxy"] = prim.IsInstanceProxy()
        if frames and self.is_moving(prim):
            silent = Output.__new__(Output)
            silent.notes, silent.files, silent.folder, silent.roots = {}, self.out.files, self.out.folder, self.out.roots
            silent.moving, silent.named, silent.shown_frame = {}, {}, ""
            result["frames"] = [function(subject, Usd.TimeCode(time), silent) for time in range(frames[0], frames[1] + 1)]
        return result
