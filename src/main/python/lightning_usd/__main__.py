"""Describes a USD stage for Lightning: `python lightning_usd shot.usda folder`.

Writes `stage.json` and `arrays.bin` into the folder, or `error.txt` with one sentence. Needs the package usd-core.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

NO_USD = 3
FAILED = 2


def main(source: str, folder: str) -> int:
    """Returns the exit code: 0, FAILED, or NO_USD without usd-core."""
    try:
        from pxr import Usd  # noqa: F401
    except ImportError:
        return NO_USD
    from output import StageError
    from stage import describe

    try:
        describe(source, Path(folder))
        return 0
    except StageError as error:
        message = str(error)
    except (MemoryError, RecursionError):
        message = "is too large for the memory of the converter"
    except Exception as error:  # usd-core raises its own kinds for damaged content
        message = "cannot be read by usd-core: " + reason(error)
    (Path(folder) / "error.txt").write_text(message, encoding="utf-8")
    return FAILED


def reason(error: Exception) -> str:
    """Returns the last sentence of an error, without the place in usd-core's own sources."""
    last = str(error).split("Error in '")[-1]
    quoted = re.search(r" : '(.*)'\s*$", last, re.DOTALL)
    lines = (quoted.group(1) if quoted else last).strip().splitlines()
    return lines[0] if lines else type(error).__name__


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2]))
