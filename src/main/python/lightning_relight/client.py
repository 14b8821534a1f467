"""Client of ``lightning serve``: sends requests and receives answers on a thread of its own. Standard library only."""

from __future__ import annotations

import itertools
import json
import os
import shutil
import socket as sockets
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any, Callable, Dict, List, Optional, Union


class RequestError(Exception):
    """Refusal of a request. The scene is as before it.

    Attributes:
        code: kind of the error, such as ``bad_edit``
        place: field of the request, or position in a file; may be empty
    """

    def __init__(self, code: str, place: str, message: str) -> None:
        super().__init__(f"{place}: {message}" if place else message)
        self.code = code
        self.place = place


class Answer:
    """Answer that may not be there yet."""

    def __init__(self, client: "Client", number: int, on_progress: Optional[Callable[[float], None]]) -> None:
        self._client = client
        self._number = number
        self._on_progress = on_progress
        self._arrived = threading.Event()
        self._message: Dict[str, Any] = {}

    def done(self) -> bool:
        """Returns whether the answer has arrived."""
        return self._arrived.is_set()

    def result(self, timeout: Optional[float] = None) -> Dict[str, Any]:
        """Waits for the result.

        Raises:
            RequestError: if the server refused the request, or it was canceled
            TimeoutError: if it takes longer than ``timeout`` seconds
            ConnectionError: if the server has ended
        """
        if not self._arrived.wait(timeout):
            raise TimeoutError(f"no answer within {timeout} seconds")
        error = self._message.get("error")
        if error is not None:
            raise RequestError(error["code"], error["place"], error["message"])
        if "result" not in self._message:
            raise ConnectionError("the server has ended")
        return self._message["result"]

    def cancel(self) -> None:
        """Ends the request as soon as possible; its result is then an error. Does not wait."""
        self._client.send("cancel", request=self._number)

    def _receive(self, message: Dict[str, Any]) -> None:
        if "progress" in message:
            if self._on_progress:
                self._on_progress(message["progress"])
        else:
            self._message = message
            self._arrived.set()


def find_program() -> str:
    """Returns Lightning's launcher: that of LIGHTNING_PROGRAM, of the folder of this package, or of the PATH."""
    name = "lightning.bat" if sys.platform == "win32" else "lightning"
    own = Path(__file__).resolve().parents[2] / "bin" / name
    found = os.environ.get("LIGHTNING_PROGRAM") or (str(own) if own.exists() else shutil.which("lightning"))
    if not found:
        raise FileNotFoundError("Lightning's program was not found; set LIGHTNING_PROGRAM to its file bin/lightning")
    return found


class Client:
    """Connection to a server. Its methods can be called on any thread."""

    def __init__(self, socket: Union[str, os.PathLike, None] = None, program: Union[str, List[str], None] = None) -> None:
        """Connects to a server that listens at a socket, or starts one that ends with this client.

        Args:
            socket: path of the socket of ``lightning serve --socket``; None to start a server
            program: Lightning's launcher, or a command as a list (default: see ``find_program``)
        """
        self._process: Optional[subprocess.Popen] = None
        self._socket: Optional[sockets.socket] = None
        if socket is not None:
            self._socket = sockets.socket(sockets.AF_UNIX, sockets.SOCK_STREAM)
            try:
                self._socket.connect(os.fspath(socket))
            except OSError:
                self._socket.close()
                raise
            self._input = self._socket.makefile("wb")
            self._output = self._socket.makefile("rb")
        else:
            command = program if isinstance(program, list) else [program or find_program()]
            self._process = subprocess.Popen(command + ["serve"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
            self._input = self._process.stdin
            self._output = self._process.stdout
        self._numbers = itertools.count(1)
        self._waiting: Dict[int, Answer] = {}
        self._lock = threading.Lock()
        self._has_ended = False
        self._reader = threading.Thread(target=self._read, name="lightning-answers", daemon=True)
        self._reader.start()

    def send(self, method: str, on_progress: Optional[Callable[[float], None]] = None, **fields: Any) -> Answer:
        """Sends a request without waiting for its answer.

        Args:
            method: name of the request, as in docs/serve.md
            on_progress: called on another thread with numbers from 0 to 1; only if the request has a progress
            fields: the request's fields; those that are None are left out
        """
        number = next(self._numbers)
        message = {"id": number, "method": method, **{k: v for k, v in fields.items() if v is not None}}
        if on_progress:
            message["progress"] = True
        answer = Answer(self, number, on_progress)
        line = json.dumps(message).encode() + b"\n"
        with self._lock:
            if self._has_ended:
                raise ConnectionError("the server has ended")
            self._waiting[number] = answer
            self._input.write(line)
            self._input.flush()
        return answer

    def request(self, method: str, **fields: Any) -> Dict[str, Any]:
        """Sends a request and waits for its result, as ``send(...).result()``."""
        return self.send(method, **fields).result()

    def _read(self) -> None:
        try:
            for line in self._output:
                message = json.loads(line)
                number = message.get("id")
                with self._lock:
                    answer = self._waiting.get(number) if "progress" in message else self._waiting.pop(number, None)
                if answer:
                    answer._receive(message)
        except (OSError, ValueError):
            pass  # The connection is closed.
        with self._lock:
            self._has_ended = True
            unanswered, self._waiting = list(self._waiting.values()), {}
        for answer in unanswered:
            answer._receive({})

    def close(self) -> None:
        """Ends the connection. The server cancels unanswered requests, and closes the scenes that it did not keep."""
        with self._lock:
            for number in list(self._waiting):
                self._try_write({"id": -number, "method": "cancel", "request": number})
            try:
                self._input.close()
            except OSError:
                pass  # The server has ended.
        if self._socket:
            try:
                self._socket.shutdown(sockets.SHUT_WR)
            except OSError:
                pass
        self._reader.join(timeout=10)
        if self._socket:
            self._socket.close()
        if self._process:
            try:
                self._process.wait(timeout=10)
            except subprocess.TimeoutExpired:
                self._process.kill()
                self._process.wait()
            self._process.stdout.close()

    def _try_write(self, message: Dict[str, Any]) -> None:
        try:
            self._input.write(json.dumps(message).encode() + b"\n")
        except (OSError, ValueError):
            pass

    def __enter__(self) -> "Client":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
