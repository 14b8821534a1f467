# SPDX-License-Identifier: Apache-2.0
"""Animation of lights that comes back from Lightning: values at each frame, as F-curves with the keys that they need.

Blender's properties have other units than Lightning's, and a light's power depends on several of them. So each frame is received as an
edit of the light, and what Blender then has becomes keys.
"""

import hashlib
import json

from . import light_nodes, lights, memory

# Attributes that change the same properties in Blender, and these properties: of the object, of its light, or of its light's node.
GROUPS = (
    (("at", "direction", "up"), ("location", "rotation_euler", "rotation_quaternion", "rotation_axis_angle")),
    (("color", "intensity", "relative_intensity", "exposure", "temperature", "bank.color", "bank.intensity", "beam_spread"),
     ("data.color", "data.energy", "data.spread", "data.exposure", "data.temperature", "data.use_temperature", "node.Color", "node.Strength", "black_body.Temperature")),
    (("radius", "width", "height"), ("data.shadow_soft_size", "data.size", "data.size_y")),
    (("angle", "dropoff"), ("data.spot_size", "data.spot_blend")),
    (("spread",), ("data.angle",)),
    (("on", "bank.on"), ("hide_render",)),
    (("diffuse",), ("data.diffuse_factor",)),
    (("specular",), ("data.specular_factor",)),
    (("casts_shadows",), ("data.use_shadow",)),
)
# Largest distance of a key that is left out from the line between its neighbors, relative to the larger of 1 and the value.
TOLERANCE = 1e-6


def by_light(exported: dict) -> dict[str, dict[str, list]]:
    """Returns the values of each animated attribute, by light and attribute. Those of a light's group have names with `bank.`."""
    result: dict[str, dict[str, list]] = {}
    tracks = exported.get("shot", {}).get("tracks", [])
    for track in tracks:
        if "light" in track:
            result.setdefault(track["light"], {})[track["attribute"]] = track["values"]
    for light in exported["lights"]:
        for track in tracks:
            if "bank" in track and track["bank"] == light["bank"]:
                result.setdefault(light["name"], {})[f"bank.{track['attribute']}"] = track["values"]
    return result


def digests(values: dict[str, list]) -> dict[str, str]:
    """Returns what a light remembers of its animation."""
    return {name: hashlib.sha256(json.dumps(v).encode()).hexdigest() for name, v in values.items()}


def receive(scene, obj, settings: dict, values: dict[str, list], first: int, groups: dict, messages: list[str]) -> None:
    """Replaces the animation of attributes whose keys were edited in Lightning; call it after the light itself was received.

    Args:
        values: values of the animated attributes at all frames from `first` on
    """
    before = memory.of_light(obj).get("tracks", {})
    after = digests(values)
    edited = {name for name in before.keys() | after.keys() if before.get(name) != after.get(name)}
    affected = [(names, paths) for names, paths in GROUPS if edited.intersection(names)]
    for name in sorted(edited - {name for names, _ in affected for name in names}):
        messages.append(f"{obj.name}: the keys of {name} stay in Lightning only")
    if any("location" in paths for _, paths in affected) and (obj.parent is not None or obj.constraints):
        affected = [(names, paths) for names, paths in affected if "location" not in paths]
        messages.append(f"{obj.name}: it has a parent or constraints, so its keyed position and direction stay in Lightning")
    if not affected:
        return
    # The frames start from the received values, except for those that Blender's animation may have changed.
    covered = {name for names, _ in affected for name in names}
    lights.store(obj, settings["name"], {name: value for name, value in settings.items() if name not in covered}, groups)
    paths = [path for _, group in affected for path in group]
    animated = {name: v for name, v in values.items() if any(name in names for names, _ in affected)}
    if animated:
        def show(i: int) -> None:
            own = {name: v[i] for name, v in animated.items() if not name.startswith("bank.")}
            bank = {name.removeprefix("bank."): v[i] for name, v in animated.items() if name.startswith("bank.")}
            at_frame = groups | {settings["bank"]: groups[settings["bank"]] | bank} if bank else groups
            lights.receive(obj, settings | own, at_frame, [])
            # A light whose group goes on again looks unchanged itself.
            known = {name: value for name, value in (settings | own).items() if name != "on" or "on" not in bank}
            lights.store(obj, settings["name"], known, at_frame)

        replace_curves(obj, paths, range(len(next(iter(animated.values())))), show, first)
    else:
        replace_curves(obj, paths, [settings], lambda _: lights.receive(obj, settings, groups, []), first)
    scene.frame_set(scene.frame_current, subframe=scene.frame_subframe)


def replace_curves(obj, paths, states, show, first: int) -> None:
    """Replaces the F-curves of properties by those of the values that they have in some states, one for each frame.

    Args:
        show: gives the object a state
        first: frame of the first state
    """
    paths = [path for path in paths if _block(obj, path)[0] is not None]
    for path in paths:
        _remove_curves(obj, path)
    rows = []
    for state in states:
        show(state)
        rows.append([_read(obj, path) for path in paths])
    for path, column in zip(paths, zip(*rows)):
        _write_curves(obj, path, column, first)


def _block(obj, path: str):
    """Returns what has a property, and the property; None if this light does not have it."""
    if path.startswith(("node.", "black_body.")):
        owner, name = path.split(".")
        node = light_nodes.own_emission(obj.data) if owner == "node" else light_nodes.black_body(obj.data)
        return node and node.inputs[name], "default_value"
    block, name = (obj.data, path.removeprefix("data.")) if path.startswith("data.") else (obj, path)
    is_other_rotation = name.startswith("rotation_") and name != {"QUATERNION": "rotation_quaternion", "AXIS_ANGLE": "rotation_axis_angle"}.get(
        obj.rotation_mode, "rotation_euler")
    return (None if is_other_rotation or not hasattr(block, name) else block), name


def _read(obj, path: str):
    block, name = _block(obj, path)
    value = getattr(block, name)
    return tuple(value) if hasattr(value, "__len__") else value


def _curves(block, name: str) -> list:
    """Returns the F-curves of a property, each with the collection that has it."""
    data = block.id_data.animation_data
    if data is None or data.action is None or data.action_slot is None:
        return []
    path = name if block == block.id_data else block.path_from_id(name)
    bags = [strip.channelbag(data.action_slot) for layer in data.action.layers for strip in layer.strips]
    return [(bag.fcurves, curve) for bag in bags if bag is not None for curve in bag.fcurves if curve.data_path == path]


def _remove_curves(obj, path: str) -> None:
    for curves, curve in _curves(*_block(obj, path)):
        curves.remove(curve)


def _write_curves(obj, path: str, values: tuple, first: int) -> None:
    if all(value == values[0] for value in values):
        return
    block, name = _block(obj, path)
    is_stepped = isinstance(values[0], bool)
    for i in _kept(values, is_stepped):
        setattr(block, name, values[i])
        block.keyframe_insert(name, frame=first + i)
    for _, curve in _curves(block, name):
        for point in curve.keyframe_points:
            point.interpolation = "CONSTANT" if is_stepped else "LINEAR"
        curve.update()


def _kept(values: tuple, is_stepped: bool) -> list[int]:
    """Returns the indices of keys between which all values lie on lines; for words, the indices of changes."""
    if is_stepped:
        return [i for i, value in enumerate(values) if i == 0 or value != values[i - 1]]
    rows = [value if isinstance(value, tuple) else (value,) for value in values]
    kept = [0]
    for i in range(1, len(rows)):
        if i == len(rows) - 1 or not _is_line(rows[kept[-1]:i + 2]):
            kept.append(i)
    return kept


def _is_line(rows: list) -> bool:
    first, last, count = rows[0], rows[-1], len(rows) - 1
    return all(abs(a + (b - a) * i / count - v) <= TOLERANCE * max(1, abs(v))
               for i, row in enumerate(rows) for a, b, v in zip(first, last, row))
