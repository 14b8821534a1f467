# SPDX-License-Identifier: Apache-2.0
"""Animation: what moves or changes is recorded at every frame; Lightning keeps the keys that it needs."""

import math

import bpy

from . import axes, lights, motion, visibility

# Properties of lights that can have keys in Lightning.
KEYED = ("color", "intensity", "exposure", "temperature", "at", "direction", "up", "on", "angle", "radius", "spread", "beam_spread", "width", "height",
         "diffuse", "specular", "casts_shadows")


def record(context, sent, names: dict, groups: dict, messages: list[str]) -> dict:
    """Returns the animation of a scene as JSON.

    Args:
        sent: names of the objects that are nodes
        names: names of the lights in Lightning
    """
    scene = context.scene
    objects = [obj for obj in context.view_layer.objects if obj.type != "LIGHT" and visibility.is_on(obj)]
    result = {"frames": [max(scene.frame_start, 0), max(scene.frame_end, scene.frame_start, 0)],
              "rate": scene.render.fps / scene.render.fps_base, "tracks": []}
    meshes = [obj for obj in objects if obj.name in sent]
    is_keyed = bool(bpy.data.actions) or any(obj.constraints or obj.animation_data for obj in objects)
    frames = range(result["frames"][0], result["frames"][1] + 1)
    compared = {frames[0], frames[len(frames) // 2], frames[-1]} if is_keyed or motion.is_possible(objects) else set()
    moving = motion.Motion(meshes)
    current, subframe = scene.frame_current, scene.frame_subframe
    values: dict[tuple, list] = {}
    for frame in frames if is_keyed else sorted(compared):
        scene.frame_set(frame)
        moving.compare_visibility(context.view_layer)
        if frame in compared:
            moving.compare(context.evaluated_depsgraph_get())
        for obj in meshes:
            values.setdefault(("node", obj.name, "matrix"), []).append([frame, axes.columns(obj.matrix_world)])
        for obj in names:
            shown = lights.describe(obj, groups, [])
            for key in KEYED:
                if key in shown:
                    values.setdefault(("light", names[obj], key), []).append([frame, shown[key]])
        if scene.camera is not None:
            for key, value in camera(scene).items():
                values.setdefault(("camera", "", key), []).append([frame, value])
    if compared:
        scene.frame_set(current, subframe=subframe)
    messages += moving.lines()
    for (target, name, attribute), keys in values.items():
        if any(value != keys[0][1] for _, value in keys):
            track = {"target": target, "name": name}
            track |= {"matrices": keys} if target == "node" else {"attribute": attribute, "keys": keys}
            result["tracks"].append(track)
    return result


def camera(scene) -> dict:
    """Returns the view of the active camera."""
    obj = scene.camera
    matrix = obj.matrix_world
    forward = -matrix.col[2].to_3d().normalized()
    position = matrix.translation
    width, height = size(scene)
    data = obj.data
    view = {"from": axes.vector(position), "to": axes.vector(position + forward * target_distance(scene.camera.data)),
            "up": axes.vector(matrix.col[1].to_3d().normalized())}
    if data.type == "PERSP":
        # The angle of a sensor belongs to the longer side, or to the one that is chosen.
        half = math.tan((data.angle_y if data.sensor_fit == "VERTICAL" else data.angle) / 2)
        view["fov"] = 2 * math.degrees(math.atan(half if fits_height(scene) else half * height / width))
    view["shift"] = shift(scene)
    opening = lens(scene)
    return view | {key: opening[key] for key in ("aperture", "focus")}


def fits_height(scene) -> bool:
    """Returns whether the camera's sensor fits the height of the picture, and not its width."""
    fit = scene.camera.data.sensor_fit
    width, height = size(scene)
    return fit == "VERTICAL" or fit == "AUTO" and height > width


def shift(scene) -> list[float]:
    """Returns the lens shift as shares of the picture's width and height; Blender's are shares of the side that the sensor fits."""
    data = scene.camera.data
    width, height = size(scene)
    side = height if fits_height(scene) else width
    return [axes.number(data.shift_x) * side / width, axes.number(data.shift_y) * side / height]


def lens(scene) -> dict:
    """Returns the opening and the focus of the active camera as Lightning's properties; a pinhole's aperture is 0."""
    data = scene.camera.data
    dof = data.dof
    is_open = dof.use_dof and data.type == "PERSP"
    # Cycles draws the first blade across the x axis; Lightning draws its first corner on top.
    blades = dof.aperture_blades if dof.aperture_blades >= 3 else 0
    rotation = math.degrees(dof.aperture_rotation) + 180 / blades - 90 if blades else 0
    return {"aperture": aperture(data, dof.aperture_fstop) if is_open else 0, "focus": focus_distance(scene.camera) if is_open else 0,
            "blades": blades if is_open else 0, "blade_rotation": axes.number(rotation) if is_open else 0}


def aperture(data, f_number: float) -> float:
    """Returns the radius of a lens of an f-number, as Cycles: the focal length is in millimeters, whatever the unit of the scene."""
    return axes.number(1e-3 * data.lens / (2 * max(f_number, 1e-5)))


def focus_distance(obj) -> float:
    """Returns the distance of a camera's plane of focus along its view direction."""
    dof = obj.data.dof
    if dof.focus_object is None:
        return axes.number(dof.focus_distance)
    view = obj.matrix_world.col[2].to_3d().normalized()
    return axes.number(abs(view.dot(obj.matrix_world.translation - dof.focus_object.matrix_world.translation)))


def target_distance(data) -> float:
    """Returns the distance of a camera's target: that of its focus, which does not depend on the objects. So their edits keep the view."""
    return min(max(axes.number(data.dof.focus_distance), 0.1), 1e4)


def size(scene) -> list[int]:
    """Returns the size of the picture in pixels."""
    render = scene.render
    return [max(1, render.resolution_x * render.resolution_percentage // 100),
            max(1, render.resolution_y * render.resolution_percentage // 100)]
