"""Scene with every kind of light that the Blender add-on sends."""

import math
import os
import subprocess
import sys
from pathlib import Path

FOLDER = Path(sys.argv[1])
if "bpy" not in sys.modules:
    os.environ["BLENDER_USER_RESOURCES"] = str(FOLDER / "user")
PROGRAM = Path(os.environ["BLENDER_USER_RESOURCES"], "extensions/user_default/lightning/program.txt")

import bpy  # noqa: E402, after the variable that it reads
import numpy  # noqa: E402


def run_program(*words: str) -> None:
    """Runs a command of the program that the add-on finds."""
    subprocess.run([PROGRAM.read_text(encoding="utf-8").strip(), *words], check=True)


def edit_file(file, *words: str) -> None:
    """Edits a scene file in Lightning, with options of `relight`, whose picture is not used."""
    run_program("relight", str(file), "-o", str(FOLDER / "a.png"), "--size", "8x8", "--indirect", "off", "--depth", "0", "--antialias", "off",
                "--no-savings", "--save", str(file), *words)


def set_in_file(file, *edits: str) -> None:
    """Edits properties of a scene file in Lightning."""
    edit_file(file, *(word for text in edits for word in ("--set", text)))


def start() -> None:
    """Starts from Blender's default scene, with the add-on."""
    bpy.ops.wm.read_factory_settings()
    bpy.ops.preferences.addon_enable(module="bl_ext.user_default.lightning")


def add_light(kind: str, name: str, location=(0, 0, 0), rotation=(0, 0, 0), **values):
    """Adds a light."""
    data = bpy.data.lights.new(name, kind)
    for key, value in values.items():
        setattr(data, key, value)
    obj = bpy.data.objects.new(name, data)
    obj.location, obj.rotation_euler = location, rotation
    bpy.context.scene.collection.objects.link(obj)
    return obj


def emission(light):
    """Returns the Emission node of a light, and its nodes."""
    light.data.use_nodes = True
    tree = light.data.node_tree
    return tree.nodes["Emission"], tree


def show_image(light):
    """Gives an area light an image whose colors change slowly, each in another direction."""
    node, tree = emission(light)
    texture = tree.nodes.new("ShaderNodeTexImage")
    texture.image = bpy.data.images.new("colors", 64, 64)
    colors = numpy.ones((64, 64, 4), dtype=numpy.float32)
    y, x = numpy.mgrid[0:64, 0:64] / 63
    colors[:, :, 0], colors[:, :, 1], colors[:, :, 2] = x, y, (2 - x - y) / 2
    texture.image.pixels.foreach_set(colors.reshape(-1))
    tree.links.new(texture.outputs["Color"], node.inputs["Color"])
    return light


def _candela(angle: float, around: float, count: int) -> float:
    """Returns a smooth value, which does not depend on the direction around the axis if there is only one."""
    shape = 0.7 * math.cos(around) + (0.4 * math.sin(2 * around) if count > 40 else 0) if count > 1 else 0
    return (1.2 + math.cos(2 * angle)) * (1 + shape * math.sin(angle) ** 2)


def show_profile(light, around=(0,)):
    """Gives a light an IES profile, whose values are those of a smooth curve every two degrees, at angles around its axis in degrees."""
    node, tree = emission(light)
    angles = range(0, 181, 2)
    text = bpy.data.texts.new("lamp.ies")
    text.write("IESNA:LM-63-2002\nTILT=NONE\n1 1000 2 91 " + str(len(around)) + " 1 2 0 0 0\n1 1 10\n" + "\n".join(str(a) for a in (*angles, *around)) + "\n"
               + "\n".join(f"{500 * _candela(math.radians(a), math.radians(h), len(around)):.6g}" for h in around for a in angles) + "\n")
    profile = tree.nodes.new("ShaderNodeTexIES")
    profile.ies = text
    profile.inputs["Strength"].default_value = 0.5
    tree.links.new(profile.outputs[0], node.inputs["Strength"])
    return light


def linked(state: str, *objects):
    """Returns a collection for light linking."""
    collection = bpy.data.collections.new(state)
    for obj in objects:
        collection.objects.link(obj)
    for item in collection.collection_objects:
        item.light_linking.link_state = state
    return collection


def build():
    """Builds the scene; returns it."""
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = 480, 270
    bpy.data.objects.remove(bpy.data.objects["Light"])
    cube = bpy.data.objects["Cube"]
    copy = bpy.data.objects.new("Copy", cube.data)
    copy.location, copy.rotation_euler, copy.scale = (4, 1, 0), (0.1, 0.2, 0.3), (0.5, 1, 2)
    scene.collection.objects.link(copy)
    bpy.context.view_layer.lightgroups.add(name="keys")
    key = add_light("POINT", "Key", (1, 2, 3), energy=500, color=(1, 0.5, 0.25), shadow_soft_size=0.3, exposure=1.5)
    key.lightgroup = "keys"
    spot = add_light("SPOT", "Spot", (0, -4, 5), (0.5, 0, 0.2), energy=800, spot_size=math.radians(50), spot_blend=0.3,
                     use_temperature=True, temperature=3200, shadow_soft_size=0)
    spot.light_linking.receiver_collection = linked("INCLUDE", cube)
    sun = add_light("SUN", "Sun", (0, 0, 9), (0.4, 0.3, 0), energy=3, angle=math.radians(2), diffuse_factor=0.5, specular_factor=0.25)
    sun.hide_render = True
    box = add_light("AREA", "Soft Box", (-3, 0, 4), (0, -0.6, 0.3), energy=200, shape="RECTANGLE", size=2, size_y=1)
    box.scale = (1.5, 2, 1)
    box.light_linking.blocker_collection = linked("EXCLUDE", copy)
    add_light("AREA", "Disc", (3, 3, 4), energy=100, shape="DISK", size=0.8, use_shadow=False)
    add_light("AREA", "Square", (3, -3, 4), energy=50, shape="SQUARE", size=0.5)
    bpy.context.view_layer.update()
    return scene


def values(obj) -> dict:
    """Returns what defines a light."""
    data = obj.data
    names = ["type", "energy", "exposure", "use_temperature", "temperature", "use_shadow", "diffuse_factor", "specular_factor"]
    names += {"POINT": ["shadow_soft_size"], "SPOT": ["shadow_soft_size", "spot_size", "spot_blend"], "SUN": ["angle"],
              "AREA": []}[data.type]
    result = {name: getattr(data, name) for name in names}
    result["color"] = list(data.color)
    if not data.use_temperature:
        del result["temperature"]
    if data.type == "AREA":
        scale = obj.matrix_world.to_scale()
        square = data.shape in ("SQUARE", "DISK")
        result["round"] = data.shape == "DISK"
        result["extent"] = [data.size * scale.x, (data.size if square else data.size_y) * scale.y]
    if data.type != "SUN":
        result["location"] = list(obj.matrix_world.translation)
    if data.type != "POINT":
        result["axes"] = [c for row in obj.matrix_world.to_3x3().normalized() for c in row]
    result["off"] = obj.hide_render
    result["group"] = obj.lightgroup
    for side in ("receiver_collection", "blocker_collection"):
        collection = getattr(obj.light_linking, side)
        result[side] = collection and sorted((o.name, i.light_linking.link_state)
                                             for o, i in zip(collection.objects, collection.collection_objects))
    return result


def assert_same(actual: dict, expected: dict, name: str, tolerance: float) -> None:
    """Compares two lights; numbers by a tolerance relative to the larger of 1 and the number."""
    assert actual.keys() == expected.keys(), (name, actual, expected)
    for key, value in expected.items():
        for one, other in zip(*[v if isinstance(v, list) else [v] for v in (actual[key], value)], strict=True):
            if isinstance(other, float):
                assert abs(one - other) <= tolerance * max(1, abs(other)), (name, key, one, other)
            else:
                assert one == other, (name, key, one, other)
