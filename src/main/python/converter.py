"""Converts files for Lightning: `python converter.py FOLDER LIBRARY`. FOLDER has `reader.py`, which uses the library.

A line of the standard input is a request: a JSON list of the arguments of the reader, which are a file, the folder that it writes into, the
memory in bytes that it may use (0 for any), and others. The answer is a line `ended with code N (MESSAGE)`, with the last line that the
reader printed. Without requests, this process ends after some time.

Each file has a process of its own, which this one only watches, because native code cannot be interrupted. On Linux it is a fork: this process
has imported the library and has no threads. Elsewhere, this process ends after one file, with the code of the reader. It ends the reader, and
itself, if the standard input ends, as it does when Lightning ends in any way. It ends the reader if it needs too much memory.
"""

from __future__ import annotations

import contextlib
import ctypes
import json
import multiprocessing
import os
import shutil
import signal
import sys
import threading
from multiprocessing.connection import wait
from pathlib import Path

IDLE_SECONDS = 30
POLL_SECONDS = 0.02
FAILED = 2
NO_LIBRARY = 3
FORKS = sys.platform == "linux"
SCRATCH = "lightning-scratch-"
MESSAGES = "messages.txt"
MAX_MESSAGE = 1000
PR_SET_PDEATHSIG = 1


def main(library: str) -> int:
    """Answers requests; returns the exit code."""
    if FORKS:
        with contextlib.suppress(ImportError):
            import reader  # noqa: F401
    while (not FORKS or wait([0], IDLE_SECONDS)) and (line := sys.stdin.readline()):
        arguments = json.loads(line)
        code = convert(arguments, library)
        message = last_line(Path(arguments[1], MESSAGES))
        if not FORKS:
            print(message)
            return code
        print(f"ended with code {code} ({message})", flush=True)
    return 0


def convert(arguments: list[str], library: str) -> int:
    """Returns the exit code of the process that reads a file, or FAILED if it was ended."""
    folder, memory = Path(arguments[1]), int(arguments[2])
    reader = multiprocessing.get_context("fork" if FORKS else "spawn").Process(target=read, args=(arguments, os.getpid()))
    reader.start()
    has_ended = threading.Event()
    if not FORKS:
        threading.Thread(target=await_end, args=(has_ended,), daemon=True).start()
    problem = ""
    while reader.sentinel not in (ready := wait([reader.sentinel, 0] if FORKS else [reader.sentinel], POLL_SECONDS)):
        if ready or has_ended.is_set():
            end(reader, folder)
        if memory and used_bytes(reader.pid) > memory:
            problem = f"needs more than {memory >> 20} MiB of memory in {library}; give Java more memory with JAVA_TOOL_OPTIONS=-Xmx8g"
            reader.kill()
    reader.join()
    if not problem and reader.exitcode < 0:
        # Damaged content can crash a library.
        problem = f"cannot be read by {library}, which ended with signal {-reader.exitcode}"
    if problem:
        (folder / "error.txt").write_text(problem, encoding="utf-8")
    return FAILED if problem else reader.exitcode


def read(arguments: list[str], parent: int) -> None:
    """Reads a file, in the process of its own."""
    if FORKS:
        # The system ends this process with its parent.
        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
        if os.getppid() != parent:
            sys.exit(FAILED)
    messages = os.open(Path(arguments[1], MESSAGES), os.O_WRONLY | os.O_CREAT, 0o600)
    for target, file in ((0, os.open(os.devnull, os.O_RDONLY)), (1, messages), (2, messages)):
        os.dup2(file, target)
    try:
        import reader
    except ImportError as error:
        print(error)
        sys.exit(NO_LIBRARY)
    sys.exit(reader.main(arguments))


def await_end(has_ended: threading.Event) -> None:
    """Waits until the other end of the standard input is closed."""
    with contextlib.suppress(OSError):
        while os.read(0, 1):
            pass
    has_ended.set()


def end(reader: multiprocessing.Process, folder: Path) -> None:
    """Ends the reader and this process, and removes what was written: Lightning, which would do it, has ended."""
    reader.kill()
    reader.join()
    shutil.rmtree(folder.parent if folder.parent.name.startswith(SCRATCH) else folder, ignore_errors=True)
    os._exit(FAILED)


def used_bytes(pid: int) -> int:
    """Returns the bytes of memory that a process uses; 0 if the system does not say."""
    with contextlib.suppress(OSError):
        return int(Path(f"/proc/{pid}/statm").read_text(encoding="ascii").split()[1]) * os.sysconf("SC_PAGE_SIZE")
    return 0


def last_line(messages: Path) -> str:
    """Returns the end of the last line of a file."""
    text = ""
    with contextlib.suppress(OSError), open(messages, "rb") as file:
        file.seek(max(0, messages.stat().st_size - MAX_MESSAGE))
        text = file.read().decode("utf-8", "replace").strip().split("\n")[-1]
    return text or "without a message"


sys.path.insert(0, sys.argv[1])
if __name__ == "__main__":
    sys.exit(main(sys.argv[2]))
