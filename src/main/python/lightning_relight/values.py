"""Conversion of values between Python and the words of edits."""

from __future__ import annotations

from typing import Tuple, Union

Value = Union[float, bool, str, Tuple[float, ...]]
"""Number, ``True`` or ``False`` of a switch, numbers of a vector or a color, or other words, such as names in quotes."""

_SWITCHES = {"yes": True, "no": False}


def parse(words: str) -> Value:
    """Returns the value of a property in the words of edits: ``"1 0.5 0"`` is ``(1.0, 0.5, 0.0)``."""
    if words in _SWITCHES:
        return _SWITCHES[words]
    try:
        numbers = tuple(float(word) for word in words.split())
    except ValueError:
        return words
    return numbers[0] if len(numbers) == 1 else numbers if numbers else words


def format(value: object) -> str:
    """Returns a value in the words of edits. Sequences and arrays of numbers are separated by spaces."""
    if isinstance(value, str):
        return value
    if isinstance(value, bool) or type(value).__name__ in ("bool_", "bool"):
        return "yes" if value else "no"
    try:
        return " ".join(repr(float(v)) for v in value)  # type: ignore[attr-defined]
    except TypeError:
        return repr(float(value))  # type: ignore[arg-type]
