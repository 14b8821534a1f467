"""Reads an OpenColorIO configuration for Lightning: `python reader.py CONFIG FOLDER MEMORY [DISPLAY VIEW]`.

CONFIG is a file (.ocio, .ocioz) or a name such as `ocio://default`. Writes `views.json` into the folder: displays and views. With DISPLAY and
VIEW, two indexes into that list, also writes `table.cube` and `table.json`. Writes `error.txt` with one sentence instead if it fails.
MEMORY is a limit in bytes. Needs the package opencolorio. `converter.py` limits the time.
"""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path

from configuration import Configuration, ConfigurationError
from table import NoNumberError, Table

FAILED = 2


def main(arguments: list[str]) -> int:
    """Returns the exit code: 0 or FAILED."""
    source, folder = arguments[0], Path(arguments[1])
    limit_memory(int(arguments[2]))
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
    except NoNumberError:
        message = "this view has results that are no finite numbers, such as those of a matrix with NaN"
    except (MemoryError, RecursionError):
        message = "needs more memory than the converter has"
    except UnicodeDecodeError:
        message = "has names that are not UTF-8"
    except OSError as error:
        message = f"the table cannot be written: {os.strerror(error.errno or 5).lower()}"
    (folder / "error.txt").write_text(message, encoding="utf-8")
    return FAILED


def limit_memory(limit: int) -> None:
    """Lets the system refuse memory above a limit, where it can."""
    try:
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    except (ImportError, OSError, ValueError):
        pass


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
