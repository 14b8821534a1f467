# SPDX-License-Identifier: Apache-2.0
"""Animation: what moves or changes is recorded at every frame; Lightning keeps the keys that it needs."""

import math

import bpy

from . import axes, lights

# Properties of lights that can have keys in Lightning.
KEYED = ("color", "intensity", "exposure", "temperature", "at", "direction", "up", "on", "angle", "radius", "spread", "width", "height",
         "diffuse", "specular", "casts_shadows")
DEFORMING = {"ARMATURE", "CLOTH", "FLUID", "MESH_CACHE", "MESH_SEQUENCE_CACHE", "OCEAN", "SOFT_BODY", "WAVE"}


def record(context, objects: list, names: dict, groups: dict, messages: list[str]) -> dict:
    """Returns the animation of a scene as JSON; `names` has the names of the lights in Lightning."""
    scene = context.scene
    result = {"frames": [max(scene.frame_start, 0), max(scene.frame_end, scene.frame_start, 0)],
              "rate": scene.render.fps / scene.render.fps_base, "tracks": []}
    meshes = [obj for obj in objects if obj.type not in ("LIGHT", "CAMERA", "EMPTY", "ARMATURE", "LATTICE", "SPEAKER", "LIGHT_PROBE")]
    deformed = [obj.name for obj in meshes if _is_deformed(obj)]
    if deformed:
        shown = ", ".join(deformed[:3]) + (" and others" if len(deformed) > 3 else "")
        messages.append(f"deformation is not sent, only the shape at the current frame: {shown}")
    if not bpy.data.actions and not any(obj.constraints or obj.animation_data for obj in objects):
        return result
    current, subframe = scene.frame_current, scene.frame_subframe
    values: dict[tuple, list] = {}
    for frame in range(result["frames"][0], result["frames"][1] + 1):
        scene.frame_set(frame)
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
    scene.frame_set(current, subframe=subframe)
    for (target, name, attribute), keys in values.items():
        if any(value != keys[0][1] for _, value in keys):
            track = {"target": target, "name": name}
            track |= {"matrices": keys} if target == "node" else {"attribute": attribute, "keys": keys}
            result["tracks"].append(track)
    return result


def _is_deformed(obj) -> bool:
    keys = getattr(obj.data, "shape_keys", None)
    return any(m.type in DEFORMING for m in obj.modifiers) or keys is not None and keys.animation_data is not None


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
    return view


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


def target_distance(data) -> float:
    """Returns the distance of a camera's target: that of its focus, which does not depend on the objects. So their edits keep the view."""
    return min(max(axes.number(data.dof.focus_distance), 0.1), 1e4)


def size(scene) -> list[int]:
    """Returns the size of the picture in pixels."""
    render = scene.render
    return [max(1, render.resolution_x * render.resolution_percentage // 100),
            max(1, render.resolution_y * render.resolution_percentage // 100)]
