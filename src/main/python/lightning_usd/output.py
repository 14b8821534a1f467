"""The description of a stage: a JSON document, and arrays beside it."""

from __future__ import annotations

import json
import math
import os
from pathlib import Path
from typing import Any

from choice import listed

MAX_BYTES = 2**31 - 65536
MAX_NODES = 1_000_000
MAX_FRAMES = 10_000
MAX_NOTES = 1000


class StageError(Exception):
    """One sentence that says why a stage cannot be described."""


class PrimError(Exception):
    """One sentence that says why a prim is left out."""


class Output:
    """Collects the description; `ref` values are [byte offset, number of bytes] in arrays.bin."""

    def __init__(self, folder: Path, roots: list[str], max_triangles: int) -> None:
        """Creates an empty description.

        Args:
            roots: folders of files that may be read
            max_triangles: triangles of all meshes, 0 for any number
        """
        self.folder = folder
        self.roots = [os.path.realpath(root) for root in roots]
        self.max_triangles = max_triangles
        self.triangles = 0
        self.arrays = open(folder / "arrays.bin", "wb")
        self.size = 0
        self.notes: dict[str, int] = {}
        # Names of what has a feature that is left out, by its kind.
        self.named: dict[str, dict[str, None]] = {}
        # Which frame is shown of what cannot be animated, for a note; empty if none is needed.
        self.shown_frame = ""
        self.moving: dict[str, list[str]] = {}
        self.files: dict[str, dict[str, str]] = {}

    def note(self, kind: str, count: int = 1) -> None:
        """Counts features that are left out or approximated."""
        if count:
            if kind not in self.notes and len(self.notes) >= MAX_NOTES:
                kind = "others"
            self.notes[kind] = self.notes.get(kind, 0) + count

    def note_named(self, kind: str, name: str) -> None:
        """Counts a feature that is left out, and lists what has it."""
        self.named.setdefault(kind, {})[name] = None

    def note_moving(self, kind: str, path: str) -> None:
        """Notes a prim of which only one of several frames is shown, unless that frame has been chosen."""
        if self.shown_frame:
            self.moving.setdefault(kind, []).append(path)

    def note_prim(self, prim: Any, text: str) -> None:
        """Says what is left out or approximated of one prim."""
        self.note(f"{prim.GetPath()}: {text}")

    def number(self, prim: Any, name: str, value: Any, fallback: float) -> float:
        """Returns a finite number; the fallback, with a note, in place of a value of another type."""
        try:
            number = float(value)
        except (TypeError, ValueError):
            self.note_prim(prim, f"{name}: expected a number, found {shown(value)}")
            return fallback
        if not math.isfinite(number):
            self.note_prim(prim, f"{name}: expected a finite number, found {shown(value)}")
            return fallback
        return number

    def vector(self, prim: Any, name: str, value: Any, fallback: list[float]) -> list[float]:
        """Returns the numbers of a vector; the fallback, with a note, in place of a value of another type."""
        try:
            found = numbers(value)[:len(fallback)]
        except (TypeError, ValueError):
            found = []
        if len(found) != len(fallback) or not all(map(math.isfinite, found)):
            self.note_prim(prim, f"{name}: expected {len(fallback)} finite numbers, found {shown(value)}")
            return fallback
        return found

    def is_inside(self, place: str) -> bool:
        """Returns whether a file may be read: also a link must lead into one of the folders."""
        real = os.path.realpath(place)
        return any(real == root or real.startswith(os.path.join(root, "")) for root in self.roots)

    def check_triangles(self, more: int) -> None:
        """Fails if there are too many triangles with more of them."""
        if self.max_triangles and self.triangles + more > self.max_triangles:
            raise StageError(f"has more than {self.max_triangles} triangles, too many for Java's memory; give it more with JAVA_TOOL_OPTIONS=-Xmx8g")

    def array(self, values: Any) -> list[int]:
        """Writes an array of usd-core as bytes of the machine, and returns its ref."""
        data = memoryview(values).cast("B") if len(values) else b""
        if self.size + len(data) > MAX_BYTES:
            raise StageError("has more than 2 GiB of meshes and instances")
        self.arrays.write(data)
        ref = [self.size, len(data)]
        self.size += len(data)
        return ref

    def file(self, asset: Any) -> dict[str, str]:
        """Returns a file that the stage names: its name, and where it can be read; no place if it is missing."""
        from pxr import Ar

        place = asset.resolvedPath
        known = self.files.get(place)
        if known is not None and place:
            return known
        if place and not Ar.IsPackageRelativePath(place) and not (os.path.isfile(place) and self.is_inside(place)):
            place = ""
        name = (asset.path.rstrip("]").split("[")[-1] or "file").replace("\\", "/").split("/")[-1]
        result = {"name": name}
        if place and not Ar.IsPackageRelativePath(place):
            result["place"] = place
        elif place:
            data = Ar.GetResolver().OpenAsset(Ar.ResolvedPath(place))
            if data and data.GetSize() <= MAX_BYTES:
                copy = self.folder / f"file{len(self.files)}{Path(name).suffix[:8]}"
                copy.write_bytes(data.GetBuffer())
                result["place"] = str(copy)
        self.files[place] = result
        return result

    def write(self, document: dict[str, Any]) -> None:
        """Ends the description."""
        self.arrays.close()
        for kind, paths in self.moving.items():
            self.note(f"{kind}, {self.shown_frame}: {listed(paths)}", len(paths))
        document["notes"] = self.notes
        document["named"] = {kind: list(names) for kind, names in self.named.items()}
        with open(self.folder / "stage.json", "w", encoding="utf-8") as out:
            # As texts of parts: writing number by number is slow, and a single text would need the memory of the file.
            for i, (key, value) in enumerate(document.items()):
                out.write(("," if i else "{") + json.dumps(key) + ":" + json.dumps(finite(value), allow_nan=False, separators=(",", ":")))
            out.write("}")


def shown(value: Any) -> str:
    """Returns a value for a message."""
    text = repr(value) if isinstance(value, (str, int, float)) else str(value)
    return text if len(text) <= 40 else text[:39] + "…"


def finite(value: Any) -> Any:
    """Returns the value with null for numbers that are infinite or none."""
    if isinstance(value, dict):
        return {key: finite(v) for key, v in value.items()}
    if isinstance(value, list):
        return [finite(v) for v in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value


def world_matrix(value: Any) -> list[float]:
    """Returns the numbers of a transform; fails if not all are finite."""
    found = numbers(value)
    if not all(map(math.isfinite, found)):
        raise PrimError("its transform has infinite or missing numbers, left out")
    return found


def numbers(value: Any) -> list[float]:
    """Returns the numbers of a vector or a matrix of usd-core, row by row."""
    try:
        found = memoryview(value).tolist()
        return [number for row in found for number in row] if found and isinstance(found[0], list) else [float(number) for number in found]
    except (TypeError, NotImplementedError):
        # Values of Python, and numbers of half precision.
        pass
    rows = [list(row) if hasattr(row, "__len__") else [row] for row in value]
    return [float(number) for row in rows for number in row]
