# SPDX-License-Identifier: Apache-2.0
"""List of what a render of Blender shows and the sent scene does not: one line for each kind, with the names of the objects."""

from . import visibility

# Objects that Lightning has no shapes for, by their type.
TYPES = {"VOLUME": "volumes are", "POINTCLOUD": "point clouds are", "GREASEPENCIL": "Grease Pencil is"}
# Names that a line shows.
MOST = 5


class LeftOut:
    """Names by the kind of what is left out."""

    def __init__(self) -> None:
        self._names: dict[str, dict[str, None]] = {}

    def add(self, kind: str, name: str) -> None:
        """Adds a name to the line of a kind."""
        self._names.setdefault(kind, {})[name] = None

    def add_type(self, obj) -> None:
        """Adds an object of a type that Lightning does not have."""
        self.add(f"{TYPES.get(obj.type, f'objects of type {obj.type} are')} not sent", obj.original.name)

    def add_rays(self, obj, name: str) -> None:
        """Adds an object that only some rays see."""
        unseen = visibility.unseen_by(obj)
        if unseen:
            self.add(f"ray visibility is not sent, so they are seen by all rays ({', '.join(unseen)})", name)
        if obj.is_shadow_catcher:
            self.add("shadow catchers are sent as plain objects", name)
        if obj.is_holdout:
            self.add("holdouts are sent as plain objects", name)

    def lines(self) -> list[str]:
        """Returns the messages."""
        return [f"{kind}: {listed(list(names))}" for kind, names in self._names.items()]


def listed(names: list[str]) -> str:
    """Returns the first names, and how many others there are."""
    rest = len(names) - MOST
    return ", ".join(names) if rest <= 1 else f"{', '.join(names[:MOST])} and {rest} others"
