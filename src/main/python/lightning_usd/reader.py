"""Reads a stage: `python reader.py PARENT shot.usda folder [memory triangles] [options]`; ends with its parent.

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

NO_USD = 3
FAILED = 2
FOLDERS = "LIGHTNING_USD_FOLDERS"


def main(parent: int, source: str, folder: str, max_triangles: int, choice: Choice = Choice()) -> int:
    """Returns the exit code: 0, FAILED, or NO_USD without usd-core."""
    end_with(parent)
    try:
        from pxr import Usd  # noqa: F401
    except ImportError:
        return NO_USD
    from output import Output, StageError
    from stage import describe

    roots = [str(Path(source).parent), *filter(None, os.environ.get(FOLDERS, "").split(os.pathsep))]
    try:
        describe(source, choice, Output(Path(folder), roots, max_triangles))
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


def end_with(parent: int) -> None:
    """Lets the system end this process with its parent, where it can."""
    try:
        import ctypes

        pr_set_pdeathsig, sigkill = 1, 9
        ctypes.CDLL(None).prctl(pr_set_pdeathsig, sigkill)
    except (OSError, AttributeError, TypeError):
        return
    if os.getppid() != parent:
        sys.exit(FAILED)


def reason(error: Exception) -> str:
    """Returns the last sentence of an error of usd-core, without the place in its own sources; another one's kind says nothing to a user."""
    last = message(error).split("Error in '")[-1]
    quoted = re.search(r" : '(.*)'\s*$", last, re.DOTALL)
    lines = (quoted.group(1) if quoted else "").strip().splitlines()
    return lines[0] if lines else "it has values that Lightning does not expect"


def parsed(words: list[str]) -> argparse.Namespace:
    """Returns the arguments."""
    parser = argparse.ArgumentParser(allow_abbrev=False)
    parser.add_argument("parent", type=int)
    parser.add_argument("source")
    parser.add_argument("folder")
    parser.add_argument("memory", nargs="?")
    parser.add_argument("triangles", nargs="?", type=int, default=0)
    parser.add_argument("--camera", default="")
    parser.add_argument("--frame", type=float)
    parser.add_argument("--variant", action="append", default=[])
    return parser.parse_args(words)


if __name__ == "__main__":
    given = parsed(sys.argv[1:])
    sys.exit(main(given.parent, given.source, given.folder, given.triangles, Choice(given.camera, given.frame, tuple(given.variant))))
