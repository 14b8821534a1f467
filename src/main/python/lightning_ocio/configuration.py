"""An OpenColorIO configuration: its displays and views, and the conversion to one of them."""

from __future__ import annotations

import os
import re
import stat
from collections.abc import Iterator
from dataclasses import dataclass

import PyOpenColorIO as ocio

MAX_VIEWS = 10000
LINEAR_REC709 = "Linear Rec.709 (sRGB)"
ASSUMED_REC709 = ("the configuration does not say how its scene-linear space relates to Rec. 709 (it has no interchange roles); "
                  "the table takes it as Rec. 709")


# A missing table has an exception of its own, which is not of the other class.
ERRORS = (ocio.Exception, ocio.ExceptionMissingFile)


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
            configuration = Configuration(ocio.Config.CreateFromFile(source))
        except ERRORS as error:
            raise ConfigurationError("cannot be read by OpenColorIO: " + reason(error)) from error
        configuration.check_files()
        return configuration

    def check_files(self) -> None:
        """Rejects tables that are pipes or devices, which may have no end."""
        context = self.config.getCurrentContext()
        for name in dict.fromkeys(file for transform in self.transforms() for file in files(transform)):
            try:
                mode = os.stat(context.resolveFileLocation(name)).st_mode
            except (*ERRORS, OSError):
                # It is missing, or in an archive.
                continue
            if not stat.S_ISREG(mode):
                raise ConfigurationError(f"its table {name!r} is a {'folder' if stat.S_ISDIR(mode) else 'pipe or device'}, expected a file")

    def transforms(self) -> Iterator[ocio.Transform]:
        """Returns the transforms of all color spaces, looks, and view and named transforms."""
        config = self.config
        for space in config.getColorSpaces(ocio.SEARCH_REFERENCE_SPACE_ALL, ocio.COLORSPACE_ALL):
            yield space.getTransform(ocio.COLORSPACE_DIR_TO_REFERENCE)
            yield space.getTransform(ocio.COLORSPACE_DIR_FROM_REFERENCE)
        for view in config.getViewTransforms():
            yield view.getTransform(ocio.VIEWTRANSFORM_DIR_TO_REFERENCE)
            yield view.getTransform(ocio.VIEWTRANSFORM_DIR_FROM_REFERENCE)
        for look in config.getLooks():
            yield look.getTransform()
            yield look.getInverseTransform()
        for named in config.getNamedTransforms():
            yield named.getTransform(ocio.TRANSFORM_DIR_FORWARD)
            yield named.getTransform(ocio.TRANSFORM_DIR_INVERSE)

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
            except ERRORS:
                self.note = ASSUMED_REC709
        try:
            steps.appendTransform(ocio.DisplayViewTransform(ocio.ROLE_SCENE_LINEAR, display, view))
            return self.config.getProcessor(steps).getOptimizedCPUProcessor(ocio.OPTIMIZATION_LOSSLESS)
        except ERRORS as error:
            raise ConfigurationError("this view cannot be used: " + reason(error)) from error

    def shows_data(self, display: str, view: str) -> bool:
        """Returns whether a view shows the numbers of an image as they are, such as Raw."""
        space = self.config.getColorSpace(self.config.getDisplayViewColorSpaceName(display, view))
        return space is not None and space.isData()


def files(transform: ocio.Transform | None) -> Iterator[str]:
    """Returns the tables that a transform names."""
    if isinstance(transform, ocio.FileTransform):
        yield transform.getSrc()
    elif isinstance(transform, ocio.GroupTransform):
        for child in transform:
            yield from files(child)


def reason(error: Exception) -> str:
    """Returns the sentence of an error of OpenColorIO, without the file's name, which the message has already."""
    text = " ".join(str(error).split())
    return re.sub(r"^Error: Loading the OCIO profile '.*?' failed\. ", "", text).rstrip(".") or "it gives no reason"
