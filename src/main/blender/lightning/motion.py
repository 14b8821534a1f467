# SPDX-License-Identifier: Apache-2.0
"""Motion that is not sent: the shapes of objects, the places of instances in their group, and what appears or disappears.

Shapes and instances are compared at a few frames only, because that takes as long as an evaluation of all modifiers.
"""

import numpy

from . import snapshot, visibility
from .left_out import LeftOut

# Modifiers that move points without keys.
DEFORMING = {"ARMATURE", "CLOTH", "FLUID", "MESH_CACHE", "MESH_SEQUENCE_CACHE", "OCEAN", "SOFT_BODY", "WAVE"}
# Largest difference of a number from itself at another frame, relative to the larger of 1 and the number: that of single precision.
TOLERANCE = 1e-5


def is_possible(objects: list) -> bool:
    """Returns whether something can move without keys. Simulations count as moving: to skip frames would harm them."""
    return any(m.type == "NODES" for obj in objects for m in obj.modifiers)


class Motion:
    """What moves, found by comparing frames."""

    def __init__(self, objects: list) -> None:
        """Starts without a frame; `objects` are those that are sent."""
        self._left_out = LeftOut()
        self._before: dict | None = None
        self._shown: set[str] | None = None
        for obj in objects:
            if any(m.type in DEFORMING for m in obj.modifiers):
                self._add("deformation", obj.name)
            if any(system.settings.type == "EMITTER" for system in obj.particle_systems):
                self._add("instances", obj.name)

    def compare(self, depsgraph) -> None:
        """Compares the current frame with the first one that was compared."""
        now = _state(depsgraph)
        before = self._before = self._before or now
        for kind, name in now.keys() | before.keys():
            if not _is_near(now.get((kind, name), []), before.get((kind, name), [])):
                self._add(kind, name)

    def compare_visibility(self, layer) -> None:
        """Compares which objects are switched on with those of the first frame."""
        shown = {obj.name for obj in layer.objects if obj.type != "LIGHT" and visibility.is_on(obj)}
        for name in shown ^ (self._shown or shown):
            self._left_out.add("objects that appear or disappear are sent as at the current frame", name)
        self._shown = self._shown or shown

    def _add(self, kind: str, name: str) -> None:
        self._left_out.add({"deformation": "deformation is not sent, only the shape at the current frame",
                            "instances": "instances that move in their group are sent as at the current frame",
                            "lights": "lights in instances that move are sent as at the current frame"}[kind], name)

    def lines(self) -> list[str]:
        """Returns the messages."""
        return self._left_out.lines()


def _state(depsgraph) -> dict[tuple[str, str], list]:
    """Returns the points of objects, the places of instances in their group, and those of lights in instances in the world."""
    result: dict[tuple[str, str], list] = {}
    for instance in depsgraph.object_instances:
        obj = instance.object
        if instance.is_instance and not snapshot.is_itself(instance):
            is_light = obj.type == "LIGHT"
            matrix = instance.matrix_world if is_light else instance.parent.matrix_world.inverted_safe() @ instance.matrix_world
            kind, values = "lights" if is_light else "instances", numpy.array(matrix).reshape(-1)
        elif obj.type == "MESH":
            values = numpy.empty(3 * len(obj.data.vertices), dtype=numpy.float32)
            obj.data.vertices.foreach_get("co", values)
            kind = "deformation"
        else:
            continue
        owner = instance.parent if instance.is_instance else obj
        result.setdefault((kind, owner.original.name), []).append(values)
    return result


def _is_near(ours: list, theirs: list) -> bool:
    return len(ours) == len(theirs) and all(a.shape == b.shape and (numpy.abs(a - b) <= TOLERANCE * numpy.maximum(1, numpy.abs(b))).all()
                                            for a, b in zip(ours, theirs))
