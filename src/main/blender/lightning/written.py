# SPDX-License-Identifier: Apache-2.0
"""Comments of a scene file that an import wrote: the scene that it was sent from, and the files next to it."""

import re
from pathlib import Path

_SENDER = re.compile(r"^# sent from: ([0-9a-f]{32})$", re.MULTILINE)
_COMMENT = re.compile(r"^# wrote: [0-9a-f]{64} ([^<>\n]+) < ([^<>\n]+)$", re.MULTILINE)


def sources(scene_file: Path) -> dict[str, str]:
    """Returns the names in the sent scene of files that were written under other names, because files of the user have theirs."""
    return dict(_COMMENT.findall(_text(scene_file)))


def sender(scene_file: Path) -> str:
    """Returns what marks the scene that the file was sent from; empty if there is none."""
    found = _SENDER.search(_text(scene_file))
    return found.group(1) if found else ""


def _text(scene_file: Path) -> str:
    return scene_file.read_text(encoding="utf-8", errors="replace") if scene_file.is_file() else ""
