# SPDX-License-Identifier: Apache-2.0
"""Camera and objects that come back from Lightning: values at each frame, as F-curves with the keys that they need."""

import math

from mathutils import Matrix

from . import animation, axes, shot

PLACEMENT = ("location", "rotation_euler", "rotation_quaternion", "rotation_axis_angle")
# Attributes of the camera that change the same properties in Blender, and these properties.
CAMERA = ((("from", "to", "up"), PLACEMENT), (("fov",), ("data.lens",)), (("shift",), ("data.shift_x", "data.shift_y")),
          (("aperture",), ("data.dof.use_dof", "data.dof.aperture_fstop")), (("focus",), ("data.dof.focus_distance",)))


def digests(exported: dict) -> dict[str, str]:
    """Returns what a scene remembers of its camera, and of the transforms of its objects."""
    keyed = _camera_values(exported)
    values = {f"camera {names[0]}": [keyed.get(name, exported["camera"].get(name)) for name in names] for names, _ in CAMERA}
    values |= {f"object {name}": matrices for name, matrices in _matrices(exported).items()}
    return animation.digests(values | {f"visible {obj['name']}": obj["visible"] for obj in exported["objects"]})


def receive(scene, exported: dict, before: dict[str, str], messages: list[str]) -> None:
    """Changes the camera and the objects, and their keys, where they were edited in Lightning.

    Args:
        before: what the scene remembers; nothing comes back without it
    """
    after = digests(exported)
    edited = {name for name in before.keys() | after.keys() if before.get(name) != after.get(name)} if before else set()
    first = exported.get("shot", {}).get("frames", [0])[0]
    for names, paths in CAMERA:
        # A scene that an earlier version sent remembers nothing of the lens.
        if scene.camera is not None and f"camera {names[0]}" in edited & before.keys():
            _receive_camera(scene, exported, names, paths, first, messages)
    matrices = _matrices(exported)
    for name in sorted(entry.removeprefix("object ") for entry in edited if entry.startswith("object ")):
        _receive_object(scene.objects.get(name), name, matrices.get(name), first, messages)
    for settings in exported["objects"]:
        obj = scene.objects.get(settings["name"])
        if obj is not None and f"visible {obj.name}" in edited:
            obj.hide_render = not settings["visible"]
    if edited:
        scene.frame_set(scene.frame_current, subframe=scene.frame_subframe)


def _camera_values(exported: dict) -> dict[str, list]:
    return {track["attribute"]: track["values"] for track in exported.get("shot", {}).get("tracks", []) if "camera" in track}


def _matrices(exported: dict) -> dict[str, list]:
    """Returns the transforms of objects at each frame; only one for an object without keys."""
    keyed = {track["node"]: track["matrices"] for track in exported.get("shot", {}).get("tracks", []) if "node" in track}
    return {obj["name"]: [obj["matrix"]] for obj in exported["objects"]} | keyed


def _is_free(obj, messages: list[str]) -> bool:
    if obj.parent is None and not obj.constraints:
        return True
    messages.append(f"{obj.name}: it has a parent or constraints, so its edited position and rotation stay in Lightning")
    return False


def _receive_camera(scene, exported: dict, names: tuple, paths: tuple, first: int, messages: list[str]) -> None:
    obj = scene.camera
    if paths is PLACEMENT and not _is_free(obj, messages):
        return
    if names == ("fov",) and obj.data.type != "PERSP":
        messages.append(f"{obj.name}: it is not a perspective camera, so its field of view stays in Lightning")
        return
    if names == ("focus",) and obj.data.dof.focus_object is not None:
        messages.append(f"{obj.name}: it focuses on an object, so its focus distance stays in Lightning")
        return
    keyed = {name: values for name, values in _camera_values(exported).items() if name in names}
    states = [exported["camera"]]
    if keyed:
        states = [exported["camera"] | {name: values[i] for name, values in keyed.items()} for i in range(len(next(iter(keyed.values()))))]
    animation.replace_curves(obj, paths, states, lambda state: _show_camera(scene, state, names), first)


def _show_camera(scene, view: dict, names: tuple) -> None:
    obj = scene.camera
    width, height = shot.size(scene)
    fits_height = shot.fits_height(scene)
    if "from" in names:
        direction = [b - a for a, b in zip(view["from"], view["to"])]
        _place(obj, axes.light_matrix(view["from"], direction, view["up"]) @ Matrix.Diagonal((*obj.scale, 1)))
    elif "fov" in names:
        half = math.tan(math.radians(view["fov"]) / 2)
        angle = 2 * math.atan(half if fits_height else half * width / height)
        if obj.data.sensor_fit == "VERTICAL":
            obj.data.angle_y = angle
        else:
            obj.data.angle = angle
    elif "aperture" in names:
        obj.data.dof.use_dof = view["aperture"] > 0
        if view["aperture"] > 0:
            obj.data.dof.aperture_fstop = 1e-3 * obj.data.lens / (2 * view["aperture"])
    elif "focus" in names:
        obj.data.dof.focus_distance = view["focus"] or math.dist(view["from"], view["to"])
    else:
        side = height if fits_height else width
        obj.data.shift_x, obj.data.shift_y = view["shift"][0] * width / side, view["shift"][1] * height / side


def _receive_object(obj, name: str, matrices: list | None, first: int, messages: list[str]) -> None:
    if matrices is None:
        messages.append(f"{name}: it was deleted or put into a group in Lightning; Blender's object stays as it is")
    elif obj is None:
        messages.append(f"{name}: its edits stay in Lightning, because Blender has no such object")
    elif _is_free(obj, messages):
        animation.replace_curves(obj, (*PLACEMENT, "scale"), matrices, lambda matrix: _place(obj, axes.blender_matrix(matrix)), first)


def _place(obj, matrix) -> None:
    """Places an object, with angles near those of the frame before."""
    before = obj.rotation_euler.copy()
    obj.matrix_world = matrix
    if obj.rotation_mode not in ("QUATERNION", "AXIS_ANGLE"):
        rotation = obj.rotation_euler.copy()
        rotation.make_compatible(before)
        obj.rotation_euler = rotation
