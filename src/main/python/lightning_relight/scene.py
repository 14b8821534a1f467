"""Scenes that a running Lightning keeps loaded."""

from __future__ import annotations

import mmap
import os
from typing import TYPE_CHECKING, Any, Dict, List, NamedTuple, Optional, Tuple, Union

from .client import Client

if TYPE_CHECKING:
    import numpy

_File = Union[str, "os.PathLike[str]"]


class Pixels(NamedTuple):
    """Picture without numpy.

    Attributes:
        width: pixels
        height: pixels
        floats: linear red, green and blue of each pixel, the top row first. Shared with the server: the next picture
            of this scene overwrites it, so copy what must stay.
    """

    width: int
    height: int
    floats: memoryview


def open(
    file: Optional[_File] = None,
    *,
    text: Optional[str] = None,
    socket: Optional[_File] = None,
    client: Optional[Client] = None,
) -> "Scene":
    """Opens a scene.

    Args:
        file: the .jen file
        text: the content of a .jen file, in place of a file
        socket: socket of a running ``lightning serve --socket``
        client: connection to share with other scenes (default: a new one, or a server of the scene's own)

    Raises:
        RequestError: if the file cannot be read or has problems
        FileNotFoundError: if Lightning is not installed
    """
    own = Client(socket=socket) if client is None else None
    connection = client if client is not None else own
    assert connection is not None
    try:
        # The program finds its own scenes by names such as scenes/bird.jen in any folder.
        path = None if file is None else os.path.abspath(file) if os.path.exists(file) else os.fspath(file)
        content = connection.request("open", file=path, text=text)
    except BaseException:
        if own:
            own.close()
        raise
    return Scene(connection, content, own is not None)


class Scene:
    """Open scene.

    Attributes:
        client: the connection
        number: number of the scene in requests
        lights: names of its lights when it was opened
        materials: names of its materials when it was opened
    """

    def __init__(self, client: Client, content: Dict[str, Any], owns_client: bool) -> None:
        self.client = client
        self.number: int = content["scene"]
        self.lights: List[str] = content["lights"]
        self.materials: List[str] = content["materials"]
        self._owns_client = owns_client
        self._mapped: Tuple[str, Optional[mmap.mmap]] = ("", None)

    def replace(
        self,
        file: Optional[_File] = None,
        *,
        text: Optional[str] = None,
        output: Optional[_File] = None,
        indirect: Optional[str] = None,
    ) -> List[str]:
        """Opens another scene in this one's place. The next picture recomputes only what differs. The history starts again.

        Args:
            file: a .jen file, or a file to import, such as a glTF file
            text: the content of a .jen file, in place of a file
            output: for a file to import, the .jen file that the import would write; its folder gets the images of the file
            indirect: for a file to import, ``"on"``, ``"off"`` or ``"auto"``

        Returns:
            notes, such as what the import left out

        Raises:
            RequestError: if the file cannot be read or has problems; this scene stays
        """
        content = self._request("replace", file=_absolute(file), text=text, output=_absolute(output), indirect=indirect)
        self.lights, self.materials = content["lights"], content["materials"]
        return content["notes"]

    def set(self, *edits: str, gesture: Optional[str] = None) -> List[str]:
        """Makes edits in the words of the command line, such as ``"sun.color=1 0 0"``: all of them, or none.

        Args:
            edits: ``name.property=value`` each
            gesture: name of a drag; edits that follow each other with the same name are one step of undo

        Returns:
            notes about edits without effect, such as that of a property that the light does not use

        Raises:
            RequestError: if an edit is wrong; ``place`` says which one
        """
        return self._request("set", edits=list(edits), gesture=gesture)["notes"]

    def get(self, *properties: str) -> Dict[str, str]:
        """Returns values of properties in the words of edits: ``{"sun.intensity": "0.4"}``."""
        return self._request("get", properties=list(properties))["values"]

    def add(self, light: str) -> None:
        """Adds a light, such as ``"fill point intensity=0.5 at=0 3 2"``."""
        self._request("add", light=light)

    def delete(self, light: str) -> None:
        """Deletes a light."""
        self._request("delete", light=light)

    def undo(self, steps: int = 1) -> None:
        """Undoes the last edits; does nothing if there are none."""
        self._request("undo", steps=steps)

    def redo(self, steps: int = 1) -> None:
        """Redoes edits that were undone."""
        self._request("redo", steps=steps)

    def picture(
        self,
        file: Optional[_File] = None,
        *,
        region: Optional[Tuple[int, int, int, int]] = None,
        light: Optional[str] = None,
        layers: bool = False,
        bits: Optional[int] = None,
    ) -> "numpy.ndarray":
        """Renders the scene and returns the picture, linear, or writes it to a file.

        Args:
            file: image file to write in place of an array: .png, .exr, .hdr, .pfm or .xpm
            region: x, y, width and height of the part to return or write, from the upper left (default: all)
            light: name of a light, to get only its part of the picture
            layers: writes all lights and other layers to an .exr
            bits: bits of a channel: 8 or 16 for .png, 16 or 32 for .exr

        Returns:
            ``float32[height, width, 3]``, a copy; None if a file is written. Needs numpy; without it use ``pixels``.
        """
        if file is not None:
            self._request("render", file=os.path.abspath(file), region=region, light=light, bits=bits, layers=layers or None)
            return None  # type: ignore[return-value]
        import numpy

        pixels = self.pixels(region=region, light=light)
        return numpy.array(pixels.floats, dtype=numpy.float32).reshape(pixels.height, pixels.width, 3)

    def pixels(self, *, region: Optional[Tuple[int, int, int, int]] = None, light: Optional[str] = None) -> Pixels:
        """Renders the scene and returns the picture in memory that is shared with the server. Needs no other package."""
        return self.map(self._request("render", memory=True, region=region, light=light))

    def map(self, result: Dict[str, Any]) -> Pixels:
        """Returns the picture of a ``render`` request that was sent by ``client`` with ``memory=True``."""
        memory = result["memory"]
        path, mapped = self._mapped
        if mapped is None or path != memory["path"]:
            with _open_file(memory["path"]) as shared:
                mapped = mmap.mmap(shared.fileno(), memory["bytes"], access=mmap.ACCESS_READ)
            self._mapped = (memory["path"], mapped)
        height, width, _ = memory["shape"]
        return Pixels(width, height, memoryview(mapped).cast("f"))

    def explain(self, x: int, y: int) -> Dict[str, Any]:
        """Returns how the color of a pixel is computed: object, material, and the share and state of each light.

        The fields are those of ``lightning explain --json``.

        Args:
            x: column from the left, from 0
            y: row from the top, from 0
        """
        return self._request("explain", pixel=[x, y])

    def save(self, file: _File, overwrite: bool = False) -> None:
        """Writes the edited scene to a .jen file. Comments and text that was not edited stay.

        Refuses to replace a file that another program changed since the scene was opened from it or saved to it, unless ``overwrite``.
        """
        self._request("save", file=os.path.abspath(file), **({"overwrite": True} if overwrite else {}))

    def close(self) -> None:
        """Closes the scene, and its server if ``open`` started it."""
        if self._owns_client:
            self.client.close()
        else:
            self._request("close")

    def _request(self, method: str, **fields: Any) -> Dict[str, Any]:
        return self.client.request(method, scene=self.number, **fields)

    def __enter__(self) -> "Scene":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def _absolute(file: Optional[_File]) -> Optional[str]:
    return None if file is None else os.path.abspath(file)


def _open_file(path: str) -> Any:
    # The module's own open shadows the built-in one.
    return os.fdopen(os.open(path, os.O_RDONLY), "rb")
