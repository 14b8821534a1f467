"""Executes a notebook and prints the texts that it prints. Arguments: folder of the package, command of Lightning as JSON, the notebook,
and optionally a file to which it is written with its outputs."""

import json
import os
import shlex
import sys
from pathlib import Path

import nbformat
from nbclient import NotebookClient

folder, command, source = sys.argv[1:4]
program = Path("lightning")
program.write_text("#!/bin/sh\nexec " + shlex.join(json.loads(command)) + ' "$@"\n')
program.chmod(0o755)
os.environ["LIGHTNING_PROGRAM"] = str(program.absolute())
os.environ["PYTHONPATH"] = folder
os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
notebook = nbformat.read(source, as_version=4)
NotebookClient(notebook, timeout=100, kernel_name="python3", resources={"metadata": {"path": os.getcwd()}}).execute()
for cell in notebook.cells:
    for output in cell.get("outputs", []):
        print(output.get("text") or sorted(output["data"]))
if len(sys.argv) > 4:
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)
        if "outputs" in cell:
            cell["outputs"] = [output for output in cell.outputs if output.get("name") != "stderr"]
    nbformat.write(notebook, sys.argv[4])
