"""Describes a USD stage for Lightning: `python reader.py shot.usda folder [memory triangles] [options]`.

Writes `stage.json` and `arrays.bin` into the folder, or `error.txt` with one sentence. Needs the package usd-core. The options `--camera=NAME`,
`--frame=TIME` and `--variant=SET=NAME` choose what is read. `converter.py` limits time and memory.

Files that the stage names must be in its folder, or in one of LIGHTNING_USD_FOLDERS.
"""

from __future__ import annotations

import argparse
import errno
import os
import re
import sys
from pathlib import Path

from choice import Choice, message
from output import Output, StageError
from stage import describe

FAILED = 2
FOLDERS = "LIGHTNING_USD_FOLDERS"


def main(arguments: list[str]) -> int:
    """Returns the exit code: 0 or FAILED."""
    given = parsed(arguments)
    source, folder = given.source, given.folder
    roots = [str(Path(source).parent), *filter(None, os.environ.get(FOLDERS, "").split(os.pathsep))]
    try:
        describe(source, Choice(given.camera, given.frame, tuple(given.variant)), Output(Path(folder), roots, given.triangles))
        return 0
    except StageError as error:
        message = str(error)
    except (MemoryError, RecursionError):
        message = "is too large for the memory of the converter"
    except OSError as error:
        message = ("needs more space than the temporary folder has" if error.errno in (errno.ENOSPC, errno.EDQUOT)
                   else f"cannot be read: {os.strerror(error.errno or errno.EIO).lower()}")
    except Exception as error:  # usd-core raises its own kinds for damaged content
        message = "cannot be read by usd-core: " + reason(error)
    # On a full disk there is no space for the sentence either, except in place of what was written.
    for written in ("arrays.bin", "stage.json"):
        if os.path.exists(os.path.join(folder, written)):
            os.truncate(os.path.join(folder, written), 0)
    (Path(folder) / "error.txt").write_text(message, encoding="utf-8")
    return FAILED


def reason(error: Exception) -> str:
    """Returns the last sentence of an error of usd-core, without the place in its own sources; another one's kind says nothing to a user."""
    last = message(error).split("Error in '")[-1]
    quoted = re.search(r" : '(.*)'\s*$", last, re.DOTALL)
    lines = (quoted.group(1) if quoted else "").strip().splitlines()
    return lines[0] if lines else "it has values that Lightning does not expect"


def parsed(words: list[str]) -> argparse.Namespace:
    """Returns the arguments."""
    parser = argparse.ArgumentParser(allow_abbrev=False)
    parser.add_argument("source")
    parser.add_argument("folder")
    parser.add_argument("memory", nargs="?")
    parser.add_argument("triangles", nargs="?", type=int, default=0)
    parser.add_argument("--camera", default="")
    parser.add_argument("--frame", type=float)
    parser.add_argument("--variant", action="append", default=[])
    return parser.parse_args(words)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
