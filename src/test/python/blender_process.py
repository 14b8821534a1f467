"""Runs scripts one after another in one Blender.

A line of the standard input is a request: a JSON list of a file for the output, a script and its arguments. The answer is a line with 0, or 1 if
the script failed. The process ends with its input, or without requests for some time.
"""

import json
import os
import runpy
import select
import sys
import traceback

import bpy  # noqa: F401, which reads where the add-on is before a script can change it

IDLE_SECONDS = 30

answers = os.fdopen(os.dup(1), "w")
while select.select([0], [], [], IDLE_SECONDS)[0] and (line := sys.stdin.readline()):
    file, *sys.argv = json.loads(line)
    output = os.open(file, os.O_WRONLY | os.O_CREAT, 0o600)
    os.dup2(output, 1)
    os.dup2(output, 2)
    os.close(output)
    # It keeps the folder of a script.
    sys.modules.pop("blender_scene", None)
    code = 0
    try:
        runpy.run_path(sys.argv[0], run_name="__main__")
    except BaseException as error:
        if not isinstance(error, SystemExit) or error.code:
            code = 1
            traceback.print_exc()
    sys.stdout.flush()
    sys.stderr.flush()
    print(code, file=answers, flush=True)
