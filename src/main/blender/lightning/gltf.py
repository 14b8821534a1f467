# SPDX-License-Identifier: Apache-2.0
"""glTF files: the JSON of binary ones is read and replaced."""

import json
import struct
from pathlib import Path

_JSON = 0x4E4F534A


def read(path: Path) -> tuple[dict, bytes]:
    """Returns the JSON of a .glb file, and the chunks that follow it."""
    data = path.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:20 + length]), data[20 + length:]


def write(path: Path, root: dict, rest: bytes) -> None:
    """Writes a .glb file."""
    text = json.dumps(root, ensure_ascii=False, separators=(",", ":"), allow_nan=False).encode()
    text += b" " * (-len(text) % 4)
    header = b"glTF" + struct.pack("<IIII", 2, 20 + len(text) + len(rest), len(text), _JSON)
    path.write_bytes(header + text + rest)


def write_binary(path: Path, rest: bytes) -> None:
    """Writes the binary chunk of a .glb file into a file of its own."""
    path.write_bytes(rest[8:8 + struct.unpack_from("<I", rest, 0)[0]] if rest else b"")


def write_text(path: Path, root: dict, binary: str) -> None:
    """Writes a .gltf file whose binary chunk is another file, in one step."""
    if root.get("buffers"):
        root["buffers"][0]["uri"] = binary
    temporary = path.with_suffix(".part")
    temporary.write_text(json.dumps(root, ensure_ascii=False, separators=(",", ":"), allow_nan=False), encoding="utf-8")
    temporary.replace(path)
