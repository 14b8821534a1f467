"""The adaptor of a shot."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any, Dict, List, Optional

from lightning_relight import Answer, Client, RequestError
from openjd.adaptor_runtime.adaptors import Adaptor, SemanticVersion
from openjd.adaptor_runtime.adaptors.configuration import AdaptorConfiguration

_RANGE = re.compile(r"(-?\d+)(?:-(-?\d+)(?::(\d+))?)?")


def frames(text: str) -> List[int]:
    """Returns the frames of a chunk, such as ``1-6``, ``1-9:2`` or ``1,4,7-9``.

    Raises:
        ValueError: if the text is something else
    """
    numbers: List[int] = []
    for part in str(text).split(","):
        match = _RANGE.fullmatch(part.strip())
        if not match or match[3] == "0":
            raise ValueError(f"frames: expected a range such as 1-6, found {part!r}")
        first = int(match[1])
        last = int(match[2]) if match[2] else first
        numbers.extend(range(first, last + 1, int(match[3] or 1)))
    return numbers


class ShotAdaptor(Adaptor[AdaptorConfiguration]):
    """Keeps a shot open in one process while a session lasts.

    Init data: ``scene`` and ``output``, a file and a folder; optional are ``program``, Lightning's launcher, ``format``,
    the pictures' extension (default: png), ``bits``, ``layers``, and ``edits``, a list such as ``["sun.intensity=2"]``.
    Run data: ``frames``, a range such as ``1-6``.
    """

    def __init__(self, init_data: Dict[str, Any], *, path_mapping_data: Optional[Dict[str, Any]] = None, **others: Any) -> None:
        super().__init__(init_data, path_mapping_data=path_mapping_data, **others)
        self._client: Optional[Client] = None
        self._scene = 0
        self._render: Optional[Answer] = None
        self._is_canceled = False

    @property
    def integration_data_interface_version(self) -> SemanticVersion:
        return SemanticVersion(major=0, minor=1)

    def on_start(self) -> None:
        """Starts the process and opens the scene."""
        self._file = Path(self.map_path(self.init_data["scene"])).resolve()
        self._folder = Path(self.map_path(self.init_data["output"])).resolve()
        self._folder.mkdir(parents=True, exist_ok=True)
        self._client = Client(program=self.init_data.get("program") or None)
        opened = self._client.request("open", file=str(self._file))
        self._scene = opened["scene"]
        if "frames" not in opened:
            raise ValueError(f"{self._file}: expected a scene with a shot block, found none")
        if self.init_data.get("edits"):
            self._client.request("set", scene=self._scene, edits=self.init_data["edits"])

    def on_run(self, run_data: Dict[str, Any]) -> None:
        """Renders the frames of a task."""
        chunk = frames(run_data["frames"])
        for done, frame in enumerate(chunk):
            if self._is_canceled:
                raise RuntimeError("canceled")
            plan = self._render_frame(frame)
            self.update_status(progress=100 * (done + 1) / len(chunk), status_message=f"frame {frame}: {plan}")

    def _render_frame(self, frame: int) -> str:
        """Writes a frame's picture. Returns what was computed for it."""
        client = self._client
        assert client is not None
        client.request("frame", scene=self._scene, frame=frame)
        file = self._folder / f"{self._file.stem}-{frame:04}.{self.init_data.get('format') or 'png'}"
        self._render = client.send("render", scene=self._scene, file=str(file), bits=self.init_data.get("bits"),
                                   layers=self.init_data.get("layers"))
        try:
            return str(self._render.result()["plan"])
        except RequestError as error:
            raise RuntimeError(f"frame {frame}: {error}") from error

    def on_cancel(self) -> None:
        """Ends the frame that is being rendered."""
        self._is_canceled = True
        if self._render:
            self._render.cancel()

    def on_cleanup(self) -> None:
        """Ends the process."""
        if self._client:
            self._client.close()
