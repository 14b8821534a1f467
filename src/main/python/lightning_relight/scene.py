"""Scenes that a running Lightning keeps loaded."""

from __future__ import annotations

import math
import mmap
import os
from typing import TYPE_CHECKING, Any, Dict, Iterable, List, Mapping, NamedTuple, Optional, Sequence, Tuple, Union

from . import layers as layered
from . import values as words
from .client import Answer, Client
from .layers import Layers
from .values import Value

if TYPE_CHECKING:
    import numpy

_File = Union[str, "os.PathLike[str]"]
_Edit = Union[str, Mapping[str, object]]


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
    folder: Optional[_File] = None,
    output: Optional[_File] = None,
    indirect: Optional[str] = None,
    light_units: Optional[str] = None,
    lighting: Optional[str] = None,
    subdivision: Optional[int] = None,
    variant: Union[str, Sequence[str], None] = None,
    camera: Optional[str] = None,
    frame: Optional[float] = None,
    socket: Optional[_File] = None,
    client: Optional[Client] = None,
) -> "Scene":
    """Opens a scene.

    Args:
        file: the .jen file, or a file to import, such as a glTF or USD file
        text: the content of a .jen file, in place of a file
        folder: folder of the textures of a text
        output: for a file to import, the .jen file that the import would write; its folder gets the images of the file
        indirect: for a file to import, ``"on"``, ``"off"`` or ``"auto"``
        light_units: for a glTF file, ``"candela"``, ``"unitless"`` or ``"watts"``
        lighting: for a file to import, ``"file"``, ``"studio"`` or ``"sky"``
        subdivision: for a USD file, refinements of subdivision surfaces, 0 to 4
        variant: for a glTF file, the variant of its materials; for a USD file, one or several such as ``"look=red"``
        camera: for a glTF or USD file, the name of the camera
        frame: for a USD file, the time code at which all of it is read, without animation
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
        content = connection.request(
            "open",
            file=path,
            text=text,
            folder=_absolute(folder),
            output=_absolute(output),
            indirect=indirect,
            light_units=light_units,
            lighting=lighting,
            subdivision=subdivision,
            variant=variant if variant is None or isinstance(variant, str) else list(variant),
            camera=camera,
            frame=frame,
        )
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
        notes: notes of its file, such as what an import left out
    """

    def __init__(self, client: Client, content: Dict[str, Any], owns_client: bool) -> None:
        self.client = client
        self.number: int = content["scene"]
        self.notes: List[str] = content["notes"]
        self._content: Optional[Dict[str, Any]] = content
        self._owns_client = owns_client
        self._mapped: Tuple[str, Optional[mmap.mmap]] = ("", None)
        self._running: Optional[Answer] = None

    def _now(self) -> Dict[str, Any]:
        if self._content is None:
            self._content = self._request("describe")
        return self._content

    @property
    def lights(self) -> List[str]:
        """Names of its lights now."""
        return list(self._now()["lights"])

    @property
    def materials(self) -> List[str]:
        """Names of its materials now."""
        return list(self._now()["materials"])

    @property
    def size(self) -> Tuple[int, int]:
        """Width and height of its picture now, in pixels."""
        width, height = self._now()["size"]
        return width, height

    @property
    def frames(self) -> Optional[Tuple[int, int]]:
        """First and last frame of its shot; None without one."""
        found = self._now().get("frames")
        return None if found is None else (found[0], found[1])

    def replace(
        self,
        file: Optional[_File] = None,
        *,
        text: Optional[str] = None,
        folder: Optional[_File] = None,
        output: Optional[_File] = None,
        indirect: Optional[str] = None,
        light_units: Optional[str] = None,
        lighting: Optional[str] = None,
        subdivision: Optional[int] = None,
        variant: Union[str, Sequence[str], None] = None,
        camera: Optional[str] = None,
        frame: Optional[float] = None,
    ) -> List[str]:
        """Opens another scene in this one's place. The next picture recomputes only what differs. The history starts again.

        The arguments are those of ``open``.

        Returns:
            notes, such as what the import left out

        Raises:
            RequestError: if the file cannot be read or has problems; this scene stays
        """
        self._content = self._request(
            "replace",
            file=_absolute(file),
            text=text,
            folder=_absolute(folder),
            output=_absolute(output),
            indirect=indirect,
            light_units=light_units,
            lighting=lighting,
            subdivision=subdivision,
            variant=variant if variant is None or isinstance(variant, str) else list(variant),
            camera=camera,
            frame=frame,
        )
        self.notes = self._content["notes"]
        return self.notes

    def set(self, *edits: _Edit, gesture: Optional[str] = None) -> List[str]:
        """Makes edits, such as ``"sun.color=1 0 0"`` or ``{"sun.color": (1, 0, 0), "lamp.on": False}``: all of them, or none.

        Args:
            edits: ``name.property=value`` each in the words of the command line, or mappings of properties to values
            gesture: name of a drag; edits that follow each other with the same name are one step of undo

        Returns:
            notes about edits without effect, such as that of a property that the light does not use

        Raises:
            RequestError: if an edit is wrong; ``place`` says which one
        """
        return self._change("set", edits=_words(edits), gesture=gesture)["notes"]

    def get(self, *properties: str) -> Dict[str, str]:
        """Returns values of properties in the words of edits: ``{"sun.intensity": "0.4"}``."""
        return self._request("get", properties=list(properties))["values"]

    def values(self, *properties: str) -> Dict[str, Value]:
        """Returns values of properties with types: ``{"sun.intensity": 0.4, "sun.color": (1.0, 1.0, 1.0), "sun.on": True}``."""
        return {name: words.parse(value) for name, value in self.get(*properties).items()}

    def add(self, light: str) -> None:
        """Adds a light, such as ``"fill point intensity=0.5 at=0 3 2"``."""
        self._change("add", light=light)

    def delete(self, light: str) -> None:
        """Deletes a light."""
        self._change("delete", light=light)

    def undo(self, steps: int = 1) -> None:
        """Undoes the last edits; does nothing if there are none."""
        self._change("undo", steps=steps)

    def redo(self, steps: int = 1) -> None:
        """Redoes edits that were undone."""
        self._change("redo", steps=steps)

    def frame(self, number: int) -> None:
        """Shows a frame of the scene's shot. Pictures are of that frame, and edits of keyframed values set keys there."""
        self._change("frame", frame=number)

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

    def layers(self) -> Layers:
        """Renders the scene and returns all of its layers as arrays. Needs numpy."""
        import numpy

        memory = self._request("render", memory=True, layers=True)["memory"]
        with _open_file(memory["path"]) as shared:
            planes = numpy.fromfile(shared, dtype="<f4").reshape(memory["shape"])
        return layered.of(memory, planes)

    def gradient(self, light: str, parameter: str = "intensity") -> "numpy.ndarray":
        """Returns how the picture changes with a parameter of a light: the derivative of each value of ``picture()``.

        The picture is linear in intensities and colors, so the derivative is the light's part of the picture, reflections included,
        divided by the parameter. It does not hold for what is brighter than floats can be.

        Args:
            light: name of the light
            parameter: ``"intensity"``; ``"exposure"``, in stops; or ``"color"``: channel c of the result is the derivative of
                channel c of the picture by channel c of the color, and all others are 0

        Returns:
            ``float32[height, width, 3]``

        Raises:
            ValueError: if a parameter is 0, because the light then has no part to divide, or if it is another one
        """
        import numpy

        if parameter not in ("intensity", "exposure", "color"):
            raise ValueError(f"parameter: expected intensity, exposure or color, found {parameter}")
        value = numpy.atleast_1d(numpy.float32(1 / math.log(2)))
        if parameter != "exposure":
            value = numpy.atleast_1d(numpy.asarray(self.values(f"{light}.{parameter}")[f"{light}.{parameter}"], dtype=numpy.float32))
            if (value == 0).any():
                raise ValueError(f"{light}.{parameter}: expected a value other than 0")
        return self.picture(light=light) / value

    def batch(self, variations: Iterable[Union[_Edit, Sequence[_Edit]]], *, light: Optional[str] = None) -> List["numpy.ndarray"]:
        """Returns a picture for each variation of the scene, which then is as before.

        Args:
            variations: edits as for ``set``, or sequences of them
            light: name of a light, to get only its part of the pictures

        Raises:
            RequestError: if an edit is wrong; the scene is as before
        """
        pictures = []
        for variation in variations:
            edits = [variation] if isinstance(variation, (str, Mapping)) else list(variation)
            before = self._request("describe")["steps"]
            after = self._change("set", edits=_words(edits))["steps"]
            try:
                pictures.append(self.picture(light=light))
            finally:
                if after > before:
                    self.undo(after - before)
        return pictures

    def explain(self, x: int, y: int) -> Dict[str, Any]:
        """Returns how the color of a pixel is computed: object, material, and the share and state of each light.

        The fields are those of ``lightning explain --json``.

        Args:
            x: column from the left, from 0
            y: row from the top, from 0
        """
        return self._request("explain", pixel=[x, y])

    def match(
        self,
        reference: _File,
        *,
        lights: Optional[Sequence[str]] = None,
        change: Sequence[str] = (),
        exposure: str = "fixed",
        white: str = "fixed",
        region: Optional[Sequence[int]] = None,
    ) -> Dict[str, Any]:
        """Sets lights so that the picture comes closest to an image; one step of undo.

        Returns the fields of ``lightning match --json``.

        Args:
            reference: an .exr, .hdr, .pfm, .png or .jpg of the picture's shape, in any size
            lights: names of the lights that may change, ``environment`` for the environment; all by default
            change: what may change besides intensities: ``colors``, ``temperatures``, ``rotation``, ``positions``, ``directions``, ``cones``
            exposure: ``free`` if the image's brightness does not count
            white: ``free`` if neither its brightness nor its tint counts
            region: x, y, width and height of the part of the image that counts
        """
        fields: Dict[str, Any] = {"reference": os.path.abspath(reference), "exposure": exposure, "white": white}
        if lights is not None:
            fields["lights"] = list(lights)
        if change:
            fields["change"] = list(change)
        if region is not None:
            fields["region"] = list(region)
        return self._change("match", **fields)

    def review(self, allow_edits: Optional[bool] = None) -> Dict[str, Any]:
        """Opens a live review page for a browser of this computer, and renders. The page follows the scene until it is closed.

        Returns its ``url``, the number of open ``pages``, the number of ``changes`` that pages made, and their ``notes``. Call it again for
        the newest ones.

        Args:
            allow_edits: lets pages change lights and the exposure, and send notes; by default as the open page does, and a first page does
                not. Another value than that of the open page ends it and opens one at another address, which keeps the notes.
        """
        self._content = None
        return self._request("review", **({} if allow_edits is None else {"allow_edits": allow_edits}))

    def end_review(self) -> None:
        """Ends the review page."""
        self._request("review", end=True)

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

    def cancel(self) -> None:
        """Ends a request that another thread waits for; its result is then an error."""
        running = self._running
        if running:
            running.cancel()

    def _change(self, method: str, **fields: Any) -> Dict[str, Any]:
        self._content = None
        return self._request(method, **fields)

    def _request(self, method: str, **fields: Any) -> Dict[str, Any]:
        answer = self.client.send(method, scene=self.number, **fields)
        self._running = answer
        try:
            return answer.result()
        finally:
            self._running = None

    def __enter__(self) -> "Scene":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def _words(edits: Iterable[_Edit]) -> List[str]:
    """Returns edits in the words of the command line."""
    all_words: List[str] = []
    for edit in edits:
        if isinstance(edit, str):
            all_words.append(edit)
        else:
            all_words.extend(f"{name}={words.format(value)}" for name, value in edit.items())
    return all_words


def _absolute(file: Optional[_File]) -> Optional[str]:
    return None if file is None else os.path.abspath(file)


def _open_file(path: str) -> Any:
    # The module's own open shadows the built-in one.
    return os.fdopen(os.open(path, os.O_RDONLY), "rb")
