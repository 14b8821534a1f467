# SPDX-License-Identifier: Apache-2.0
"""Finds and runs Lightning."""

import shutil
import subprocess
from pathlib import Path

import bpy


class ProgramError(Exception):
    """Lightning is missing or rejected its input; the message is for the user."""


def find() -> str:
    """Returns the program: of the preferences, of `lightning blender --install`, or of the search path."""
    addon = bpy.context.preferences.addons.get(__package__)
    chosen = bpy.path.abspath(addon.preferences.program) if addon and addon.preferences.program else ""
    installed = Path(__file__).with_name("program.txt")
    candidates = [chosen, installed.read_text(encoding="utf-8").strip() if installed.is_file() else "", shutil.which("lightning") or ""]
    for candidate in candidates:
        if candidate and Path(candidate).is_file():
            return candidate
    raise ProgramError("Lightning was not found: choose its program in the add-on's preferences")


def run(*arguments: str) -> list[str]:
    """Runs a command; returns its messages."""
    done = subprocess.run([find(), *arguments], capture_output=True, text=True, encoding="utf-8", check=False)
    lines = [line for line in (done.stdout + done.stderr).splitlines() if line.strip() and not line.startswith("WARNING: Using incubator")]
    if done.returncode != 0:
        raise ProgramError(lines[0] if lines else f"Lightning ended with code {done.returncode}")
    return lines


def start_editor(scene: Path) -> None:
    """Opens a scene in Lightning's window."""
    subprocess.Popen([find(), str(scene)])
