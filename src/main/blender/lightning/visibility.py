# SPDX-License-Identifier: Apache-2.0
"""Visibility: what a render shows, what the viewport shows, and what only some rays see."""

import contextlib
import functools

import bpy

# Kinds of rays that Lightning's shapes cannot be hidden from one by one, by the property of objects.
RAYS = {"visible_diffuse": "diffuse", "visible_glossy": "glossy", "visible_transmission": "transmission",
        "visible_volume_scatter": "volume scatter", "visible_shadow": "shadow"}


def is_portal(obj) -> bool:
    """Returns whether a light has no light of its own: Cycles only samples the world through it."""
    return bpy.context.scene.render.engine == "CYCLES" and obj.type == "LIGHT" and obj.data.type == "AREA" and obj.data.cycles.is_portal


def is_on(obj) -> bool:
    """Returns whether a render shows an object: it and a collection that contains it are switched on."""
    return not obj.hide_render and _is_shown(obj, bpy.context.view_layer.layer_collection)


def _is_shown(obj, layer) -> bool:
    if layer.exclude or layer.collection.hide_render:
        return False
    return obj.name in layer.collection.objects or any(_is_shown(obj, child) for child in layer.children)


@contextlib.contextmanager
def evaluated():
    """Shows in the viewport, for a while, what only a render shows: Blender does not compute the places of objects that the viewport hides."""
    layer = bpy.context.view_layer
    hidden = [obj for obj in layer.objects if not obj.visible_get() and is_on(obj)]
    undo = [functools.partial(obj.hide_set, True) for obj in hidden if obj.hide_get()]

    def show(block) -> None:
        if block.hide_viewport:
            block.hide_viewport = False
            undo.append(functools.partial(setattr, block, "hide_viewport", True))

    try:
        if hidden:
            for collection in _layers(layer.layer_collection):
                show(collection)
                show(collection.collection)
            for obj in hidden:
                show(obj)
                obj.hide_set(False)
            layer.update()
        yield
    finally:
        for restore in reversed(undo):
            with contextlib.suppress(ReferenceError):  # An object can be gone by now.
                restore()


def _layers(layer):
    """Yields a layer's collections that are not excluded."""
    if not layer.exclude:
        yield layer
        for child in layer.children:
            yield from _layers(child)


def in_instances(scene) -> list:
    """Returns the objects of the collections that a scene has instances of, also nested ones."""
    found: dict = {}
    waiting = [obj.instance_collection for obj in scene.objects if obj.instance_collection is not None]
    while waiting:
        collection = waiting.pop()
        if collection not in found:
            found[collection] = list(collection.all_objects)
            waiting += [obj.instance_collection for obj in found[collection] if obj.instance_collection is not None]
    return [obj for objects in found.values() for obj in objects]


def is_seen_by_camera(obj, view_layer) -> bool:
    """Returns whether a camera sees an object without a mirror."""
    return obj.visible_camera and not obj.indirect_only_get(view_layer=view_layer)


def unseen_by(obj) -> list[str]:
    """Returns the rays that an object is hidden from, except those of the camera."""
    return [name for key, name in RAYS.items() if not getattr(obj, key)]
