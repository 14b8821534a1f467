"""What is chosen of a stage."""

from __future__ import annotations

from typing import NamedTuple


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


def listed(names: list[str], limit: int = 20) -> str:
    """Returns names for a message; of many the first."""
    return ", ".join(f"'{name}'" for name in names[:limit]) + (" …" if len(names) > limit else "")
