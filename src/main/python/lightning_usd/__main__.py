"""Describes a USD stage for Lightning: `python lightning_usd shot.usda folder [memory triangles] [options]`.

Writes `stage.json` and `arrays.bin` into the folder, or `error.txt` with one sentence. Needs the package usd-core. The options `--camera=NAME`,
`--frame=TIME` and `--variant=SET=NAME` choose what is read.

This process only watches another one that reads the stage, because code of usd-core cannot be interrupted. It ends it if the standard input
ends, as it does when Lightning ends in any way, and if it needs too much memory.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import threading
from pathlib import Path

POLL_SECONDS = 0.02
FAILED = 2
SCRATCH = "lightning-scratch-"


def main(arguments: list[str]) -> int:
    """Returns the exit code of the reader, or FAILED if it was ended."""
    folder = Path(arguments[1])
    memory = int(arguments[2]) if len(arguments) > 2 and arguments[2].isdigit() else 0
    reader = subprocess.Popen([sys.executable, "-B", str(Path(__file__).with_name("reader.py")), str(os.getpid()), *arguments],
                              stdin=subprocess.DEVNULL, start_new_session=True)
    has_ended = threading.Event()
    if memory:
        threading.Thread(target=await_end, args=(has_ended,), daemon=True).start()
    while True:
        try:
            code = reader.wait(POLL_SECONDS)
            if code < 0:
                # Damaged content can crash usd-core.
                (folder / "error.txt").write_text(f"cannot be read by usd-core, which ended with signal {-code}", encoding="utf-8")
                return FAILED
            return code
        except subprocess.TimeoutExpired:
            pass
        if has_ended.is_set():
            end(reader)
            remove(folder)
            return FAILED
        if memory and used_bytes(reader.pid) > memory:
            end(reader)
            text = f"needs more than {memory >> 20} MiB of memory in usd-core; give Java more memory with JAVA_TOOL_OPTIONS=-Xmx8g"
            (folder / "error.txt").write_text(text, encoding="utf-8")
            return FAILED


def await_end(has_ended: threading.Event) -> None:
    """Waits until the other end of the standard input is closed."""
    try:
        while os.read(0, 1):
            pass
    except OSError:
        pass
    has_ended.set()


def end(reader: subprocess.Popen) -> None:
    """Ends the reader, and what it started."""
    try:
        os.killpg(reader.pid, 9)
    except (AttributeError, OSError):
        reader.kill()
    reader.wait()


def remove(folder: Path) -> None:
    """Removes what was written: Lightning, which would do it, has ended."""
    shutil.rmtree(folder.parent if folder.parent.name.startswith(SCRATCH) else folder, ignore_errors=True)


def used_bytes(pid: int) -> int:
    """Returns the bytes of memory that a process uses; 0 if the system does not say."""
    try:
        with open(f"/proc/{pid}/statm", encoding="ascii") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")
    except (OSError, ValueError, IndexError):
        return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
