"""An OpenColorIO configuration: its displays and views, and the conversion to one of them."""

from __future__ import annotations

import re
from dataclasses import dataclass

import PyOpenColorIO as ocio

MAX_VIEWS = 10000
LINEAR_REC709 = "Linear Rec.709 (sRGB)"
ASSUMED_REC709 = ("the configuration does not say how its scene-linear space relates to Rec. 709 (it has no interchange roles); "
                  "the table takes it as Rec. 709")


class ConfigurationError(Exception):
    """One sentence about a configuration that cannot be used."""


@dataclass
class Configuration:
    """A configuration and what there is to say about its use."""

    config: ocio.Config
    note: str = ""

    @staticmethod
    def read(source: str) -> Configuration:
        """Reads a file, or a built-in configuration such as `ocio://default`."""
        ocio.SetLoggingLevel(ocio.LOGGING_LEVEL_NONE)
        try:
            return Configuration(ocio.Config.CreateFromFile(source))
        except ocio.Exception as error:
            raise ConfigurationError("cannot be read by OpenColorIO: " + reason(error)) from error

    def views(self) -> dict:
        """Returns the active displays with their views and default views; the first display is the default."""
        default = self.config.getDefaultDisplay()
        displays = [{"name": name, "views": list(self.config.getViews(name)), "defaultView": self.config.getDefaultView(name)}
                    for name in self.config.getDisplays()]
        displays = [display for display in displays if display["views"]]
        if not displays:
            raise ConfigurationError("has no displays with views")
        if sum(len(display["views"]) for display in displays) > MAX_VIEWS:
            raise ConfigurationError(f"has more than {MAX_VIEWS} views")
        displays.sort(key=lambda display: display["name"] != default)
        return {"displays": displays}

    def processor(self, display: str, view: str) -> ocio.CPUProcessor:
        """Returns the exact conversion from linear Rec. 709 to a view; sets the note if the primaries had to be assumed."""
        if not self.config.hasRole(ocio.ROLE_SCENE_LINEAR):
            raise ConfigurationError("has no role scene_linear, the color space of rendered light")
        steps = ocio.GroupTransform()
        if not self.shows_data(display, view):
            try:
                steps.appendTransform(ocio.Config.GetProcessorFromBuiltinColorSpace(
                    LINEAR_REC709, self.config, ocio.ROLE_SCENE_LINEAR).createGroupTransform())
            except ocio.Exception:
                self.note = ASSUMED_REC709
        try:
            steps.appendTransform(ocio.DisplayViewTransform(ocio.ROLE_SCENE_LINEAR, display, view))
            return self.config.getProcessor(steps).getOptimizedCPUProcessor(ocio.OPTIMIZATION_LOSSLESS)
        except ocio.Exception as error:
            raise ConfigurationError("this view cannot be used: " + reason(error)) from error

    def shows_data(self, display: str, view: str) -> bool:
        """Returns whether a view shows the numbers of an image as they are, such as Raw."""
        space = self.config.getColorSpace(self.config.getDisplayViewColorSpaceName(display, view))
        return space is not None and space.isData()


def reason(error: Exception) -> str:
    """Returns the sentence of an error of OpenColorIO, without the file's name, which the message has already."""
    text = " ".join(str(error).split())
    return re.sub(r"^Error: Loading the OCIO profile '.*?' failed\. ", "", text).rstrip(".") or "it gives no reason"
