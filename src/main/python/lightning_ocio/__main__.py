"""Reads an OpenColorIO configuration for Lightning: `python lightning_ocio CONFIG FOLDER MEMORY [DISPLAY VIEW]`.

CONFIG is a file (.ocio, .ocioz) or a name such as `ocio://default`. Writes `views.json` into the folder: displays and views. With DISPLAY and
VIEW, two indexes into that list, also writes `table.cube` and `table.json`. Writes `error.txt` with one sentence instead if it fails.

Ends if the standard input ends, as it does when Lightning ends in any way. MEMORY is a limit in bytes. Needs the package opencolorio.
"""

from __future__ import annotations

import json
import os
import sys
import threading
from pathlib import Path

NO_OCIO = 3
FAILED = 2


def main(arguments: list[str]) -> int:
    """Returns the exit code: 0, FAILED, or NO_OCIO without opencolorio."""
    source, folder, memory = arguments[0], Path(arguments[1]), int(arguments[2])
    threading.Thread(target=end_with_input, daemon=True).start()
    limit_memory(memory)
    try:
        import PyOpenColorIO  # noqa: F401
    except ImportError:
        return NO_OCIO
    from configuration import Configuration, ConfigurationError
    from table import Table

    try:
        configuration = Configuration.read(source)
        views = configuration.views()
        (folder / "views.json").write_text(json.dumps(views), encoding="utf-8")
        if len(arguments) > 3:
            display = views["displays"][int(arguments[3])]
            view = display["views"][int(arguments[4])]
            table = Table.bake(configuration.processor(display["name"], view))
            table.write_cube(folder / "table.cube", source, display["name"], view, configuration.note)
            (folder / "table.json").write_text(json.dumps({"note": configuration.note, **table.facts()}), encoding="utf-8")
        return 0
    except ConfigurationError as error:
        message = str(error)
    except (MemoryError, RecursionError):
        message = "needs more memory than the converter has"
    except UnicodeDecodeError:
        message = "has names that are not UTF-8"
    except OSError as error:
        message = f"the table cannot be written: {os.strerror(error.errno or 5).lower()}"
    (folder / "error.txt").write_text(message, encoding="utf-8")
    return FAILED


def end_with_input() -> None:
    """Ends this process when the other end of the standard input is closed."""
    try:
        while os.read(0, 1):
            pass
    except OSError:
        pass
    os._exit(FAILED)


def limit_memory(limit: int) -> None:
    """Lets the system refuse memory above a limit, where it can."""
    try:
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    except (ImportError, OSError, ValueError):
        pass


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
