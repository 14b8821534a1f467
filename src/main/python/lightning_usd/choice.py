"""What is chosen of a stage, and texts of messages."""

from __future__ import annotations

from typing import Any, NamedTuple


class Choice(NamedTuple):
    """Choice of what is read of a stage.

    Attributes:
        camera: name or path of the camera; empty for that of the render settings, or the first
        frame: time code of the only frame; None for all
        variants: choices such as `look=red` or `/World/car:look=red`
    """

    camera: str = ""
    frame: float | None = None
    variants: tuple[str, ...] = ()


def message(error: Any) -> str:
    """Returns the message of an error of usd-core, also with bytes of a damaged file that are no text."""
    try:
        return str(error)
    except UnicodeDecodeError as bytes_error:
        return bytes_error.object.decode("utf-8", "replace")


def listed(names: list[str], limit: int = 20) -> str:
    """Returns names for a message; of many the first."""
    return ", ".join(f"'{name}'" for name in names[:limit]) + (" …" if len(names) > limit else "")
