# SPDX-License-Identifier: Apache-2.0
"""Binary glTF files: their JSON is read and replaced."""

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
