"""Values of a prim's attributes at many times."""

from __future__ import annotations

from typing import Any

from pxr import Usd


class Values:
    """Attributes of a prim; those that do not change over time are read once."""

    def __init__(self, prim: Usd.Prim) -> None:
        self.prim = prim
        self.moving: dict[str, Usd.Attribute] = {}
        self.fixed: dict[str, Any] = {}

    def get(self, name: str, time: Usd.TimeCode, fallback: Any) -> Any:
        """Returns the value of an attribute, also by its name without `inputs:` in old files."""
        if name not in self.fixed and name not in self.moving:
            attribute = self.find(name)
            if attribute and attribute.ValueMightBeTimeVarying():
                self.moving[name] = attribute
            else:
                self.fixed[name] = attribute.Get(time) if attribute else None
        found = self.moving[name].Get(time) if name in self.moving else self.fixed[name]
        return fallback if found is None else found

    def find(self, name: str) -> Usd.Attribute:
        """Returns the attribute with a written value, or the one of the schema."""
        candidates = [self.prim.GetAttribute(candidate) for candidate in (name, name.removeprefix("inputs:"))]
        return next((attribute for attribute in candidates if attribute and attribute.HasAuthoredValue()), candidates[0])
