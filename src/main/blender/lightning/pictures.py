# SPDX-License-Identifier: Apache-2.0
"""Pictures of the live view: requests to the server, and the image that shows them."""

import time

import bpy
import numpy

IMAGE = "Lightning"
# Milliseconds in which a coarse picture is traced, and those after which a picture is late enough to need one first.
COARSE = 15
LATE = 60


class Pictures:
    """Requests of the newest picture. A coarse one comes first if the exact one of the last edit of this kind was late."""

    def __init__(self, client) -> None:
        self._client = client
        self._coarse = None
        self._exact = None
        self._start = 0.0
        self._kind = ""
        self._milliseconds: dict[str, float] = {}
        self._is_coarse_shown = False

    @property
    def is_waiting(self) -> bool:
        """Whether the exact picture has not arrived."""
        return self._exact is not None

    @property
    def is_coarse_shown(self) -> bool:
        """Whether the picture that is shown is a coarse one."""
        return self.is_waiting and self._is_coarse_shown

    @property
    def seconds(self) -> float:
        """Seconds since the request."""
        return time.perf_counter() - self._start

    def request(self, scene: int, kind: str, expected: float) -> None:
        """Requests pictures of an open scene.

        Args:
            scene: its number at the server
            kind: of the edit; those of a kind take a similar time
            expected: milliseconds of the first exact picture of a kind
        """
        self._start = time.perf_counter()
        self._kind = kind
        self._is_coarse_shown = False
        if self._milliseconds.get(kind, expected) > LATE:
            self._coarse = self._client.send("render", scene=scene, coarse=COARSE, memory=True)
        self._exact = self._client.send("render", scene=scene, memory=True)

    def cancel(self) -> None:
        """Cancels the requests."""
        for answer in (self._coarse, self._exact):
            if answer is not None:
                answer.cancel()
        self._coarse = self._exact = None

    def show_coarse(self, size: list[int]) -> bool:
        """Shows the coarse picture, enlarged to a size, if it has arrived; returns whether it has."""
        if self._coarse is None or not self._coarse.done():
            return False
        answer, self._coarse = self._coarse, None
        colors = _colors(answer)
        show(enlarged(colors, *size))
        self._is_coarse_shown = True
        return True

    def show_exact(self) -> bool:
        """Shows the exact picture if it has arrived; returns whether it has."""
        if self._exact is None or not self._exact.done():
            return False
        answer, self._exact, self._coarse = self._exact, None, None
        show(_colors(answer))
        self._milliseconds[self._kind] = answer.result()["milliseconds"]
        return True


def _colors(answer):
    memory = answer.result()["memory"]
    return numpy.fromfile(memory["path"], dtype="<f4").reshape(memory["shape"])


def enlarged(colors, width: int, height: int):
    """Repeats the pixels of a picture up to a size."""
    rows = numpy.arange(height) * colors.shape[0] // height
    columns = numpy.arange(width) * colors.shape[1] // width
    return colors[rows[:, None], columns]


def show(colors) -> None:
    """Shows linear colors, from the top row, in the image."""
    height, width, _ = colors.shape
    image = bpy.data.images.get(IMAGE)
    if image is not None and (image.source != "GENERATED" or not image.is_float):
        image.name = f"{IMAGE} (old)"
        image = None
    if image is None:
        image = bpy.data.images.new(IMAGE, width, height, float_buffer=True)
        # Editors apply the scene's view transform.
        image.use_view_as_render = True
        _fill_empty_editors(image)
    elif tuple(image.size) != (width, height):
        image.scale(width, height)
    pixels = numpy.ones((height, width, 4), dtype=numpy.float32)
    pixels[:, :, :3] = colors[::-1]
    image.pixels.foreach_set(pixels.reshape(-1))
    image.update()


def _fill_empty_editors(image) -> None:
    """Shows an image in the image editors that show none."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "IMAGE_EDITOR" and area.spaces.active.image is None:
                area.spaces.active.image = image
