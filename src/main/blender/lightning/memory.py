# SPDX-License-Identifier: Apache-2.0
"""What scenes and lights remember of Lightning: JSON in a custom property. A value of another shape counts as none."""

import json
import math

PROPERTY = "lightning"
_GROUP = {"intensity?": float, "color?": (float, float, float), "on?": bool, "solo?": bool}
_SCENE = {"banks?": {str: _GROUP},
          "world?": {"environment?": str, "intensity": float, "rotation": float, "background": [float]},
          "picture?": {"lightning": {"size": (int, int), "exposure": float, "view": str}, "blender": dict},
          "id?": str, "digest?": str, "views?": {str: str}, "surfaces?": {"values": {str: dict}, "kept": {str: {str: (object, object)}}},
          "instances?": {str: {"settings": dict, "tracks": {str: str}}}, "lost?": [str]}
_LIGHT = {"name": str, "settings": {"profile?": str, "gobo?": str, "texture?": str}, "shown": dict, "group": _GROUP, "tracks": {str: str}}


def of_scene(scene) -> dict:
    """Returns what a scene remembers: light groups, world, picture, views, materials, and the digest of the scene file."""
    return _read(scene, _SCENE)


def of_light(obj) -> dict:
    """Returns what a light remembers: its settings in Lightning, and what Blender showed of it then. Empty if it was never exchanged."""
    return _read(obj, _LIGHT)


def store(block, content: dict) -> None:
    """Stores what a scene or a light remembers."""
    block[PROPERTY] = json.dumps(content)


def damage(blocks) -> list[str]:
    """Returns a message for each block with something that cannot be read."""
    return [f"{block.name}: its custom property {PROPERTY} is damaged, and was not used" for block in blocks
            if PROPERTY in block and not _read(block, _LIGHT if hasattr(block, "matrix_world") else _SCENE)]


def _read(block, shape: dict) -> dict:
    try:
        content = json.loads(block.get(PROPERTY, "{}"), parse_constant=_reject, parse_float=_finite)
    except (ValueError, TypeError, RecursionError):
        return {}
    return content if content and _fits(content, shape) else {}


def _reject(word: str):
    raise ValueError(word)


def _finite(digits: str) -> float:
    number = float(digits)
    return number if math.isfinite(number) else _reject(digits)


def _fits(value, shape) -> bool:
    """Returns whether a value has a shape: a type, a list of values of a shape, a tuple of shapes, or a dictionary. Other keys are free."""
    if isinstance(shape, list):
        return isinstance(value, list) and all(_fits(item, shape[0]) for item in value)
    if isinstance(shape, tuple):
        return isinstance(value, list) and len(value) == len(shape) and all(map(_fits, value, shape))
    if not isinstance(shape, dict):
        return isinstance(value, (int, float) if shape is float else shape) and not (shape in (int, float) and isinstance(value, bool))
    if not isinstance(value, dict):
        return False
    if str in shape:
        return all(_fits(item, shape[str]) for item in value.values())
    return all(_fits(value[key.removesuffix("?")], inner) if key.removesuffix("?") in value else key.endswith("?")
               for key, inner in shape.items())
