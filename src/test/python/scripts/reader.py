"""Runs a script of a test, in a fork of a process that has imported what most scripts use: `main/python/converter.py`."""

import contextlib
import importlib
import os
import runpy
import sys
import traceback
from pathlib import Path

# Without it, numpy starts threads, which a fork loses.
os.environ["OPENBLAS_NUM_THREADS"] = "1"
for name in ("pxr.Usd", "pxr.UsdGeom", "pxr.UsdLux", "numpy", "OpenEXR", "PyOpenColorIO"):
    with contextlib.suppress(ImportError):
        importlib.import_module(name)


def main(arguments: list[str]) -> int:
    """Runs `[working folder, folder of results, memory, words of Python's command line]`; returns 0.

    Writes `output.txt` with the output and the errors of the script, and `failed` if it fails.
    """
    del sys.modules["reader"]
    results, words = Path(arguments[1]), arguments[3:]
    with open(results / "output.txt", "wb") as output:
        os.dup2(output.fileno(), 1)
        os.dup2(output.fileno(), 2)
    os.chdir(arguments[0])
    try:
        if words[0] == "-c":
            sys.argv, sys.path[0] = ["-c", *words[2:]], ""
            exec(compile(words[1], "<string>", "exec"), {"__name__": "__main__"})
        else:
            sys.argv, sys.path[0] = words, str(Path(words[0]).parent)
            runpy.run_path(words[0], run_name="__main__")
    except BaseException as error:
        if not isinstance(error, SystemExit) or error.code:
            (results / "failed").touch()
            traceback.print_exc()
    sys.stdout.flush()
    sys.stderr.flush()
    return 0
