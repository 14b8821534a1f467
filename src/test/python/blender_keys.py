"""Sends an animated scene to Lightning, edits keys of lights there, and gets them back."""

import json

import blender_scene as sample
import bpy
from mathutils import Vector

FILE = sample.FOLDER / "shot.jen"
PRECISION = 4e-6
KEYED = ("at", "direction", "color", "intensity", "exposure", "radius", "angle", "on", "width")


def call(operator) -> None:
    assert operator(filepath=str(FILE)) == {"FINISHED"}
    bpy.context.view_layer.update()


def exported() -> dict:
    """Returns what Lightning has, by light and attribute, at frames 1 to 12."""
    target = sample.FOLDER / "lights.json"
    sample.run_program("export-lights", str(FILE), "-o", str(target), "--quiet")
    root = json.loads(target.read_text(encoding="utf-8"))
    result = {}
    for light in root["lights"]:
        own = {t["attribute"]: t["values"] for t in root["shot"]["tracks"] if t.get("light") == light["name"]}
        result[light["name"]] = [{key: own[key][i] if key in own else light[key] for key in KEYED} | {"type": light["type"]} for i in range(12)]
    return result


def shown() -> dict:
    """Returns what Blender shows, in Lightning's terms."""
    result = {}
    for frame in range(1, 13):
        scene.frame_set(frame)
        for obj in transfer.lamps(scene):
            result.setdefault(obj.name, []).append(lights.describe(obj, {}, []))
    scene.frame_set(4)
    return result


def assert_same(name: str) -> None:
    """Compares all lights at all frames."""
    blender, lightning = shown(), exported()
    assert blender.keys() == lightning.keys(), (blender.keys(), lightning.keys())
    for light, frames in lightning.items():
        for i, frame in enumerate(frames):
            here = blender[light][i]
            for key in KEYED:
                unused = key == "direction" and here["type"] == "point" or key == "at" and here["type"] == "directional"
                if key in here and not unused:
                    wanted = list(Vector(frame[key]).normalized()) if key == "direction" else frame[key]
                    ours, theirs = ([v] if not isinstance(v, list) else v for v in (here[key], wanted))
                    assert all(abs(a - b) <= PRECISION * max(1, abs(b)) for a, b in zip(ours, theirs)), (name, light, i + 1, key, ours, theirs)


def curves() -> list:
    """Returns all F-curves with their keys."""
    return [(action.name, curve.data_path, curve.array_index,
             [(tuple(p.co), tuple(p.handle_left), tuple(p.handle_right), p.interpolation) for p in curve.keyframe_points])
            for action in sorted(bpy.data.actions, key=lambda a: a.name) for layer in action.layers for strip in layer.strips
            for bag in strip.channelbags for curve in bag.fcurves]


def replace_keys(edited: str) -> None:
    """Replaces keys of lights in the scene file."""
    text = FILE.read_text(encoding="utf-8")
    start = text.index("\nshot {")
    FILE.write_text(text[:start] + f"\nshot {{\n  frames 1 12\n  rate 24\n{edited}}}\n", encoding="utf-8")


sample.start()
scene = sample.build()
from bl_ext.user_default.lightning import axes, lights, shot, transfer  # noqa: E402, after the add-on is enabled

# Without groups and temperatures, a description is in Lightning's terms.
bpy.data.objects["Key"].lightgroup = ""
bpy.data.objects["Spot"].data.use_temperature = False
scene.frame_start, scene.frame_end = 1, 12
scene.frame_set(4)
key, spot, disc = (bpy.data.objects[name] for name in ("Key", "Spot", "Disc"))
for frame, place, energy in ((1, (1, 2, 3), 500), (7, (2, 2, 4), 900), (12, (0, 0, 5), 100)):
    key.location, key.data.energy = place, energy
    key.keyframe_insert("location", frame=frame)
    key.data.keyframe_insert("energy", frame=frame)
for frame, size in ((2, 0.5), (9, 2)):
    disc.data.size = size
    disc.data.keyframe_insert("size", frame=frame)
scene.frame_set(4)
call(bpy.ops.lightning.send)
before = curves()
assert_same("sent")
call(bpy.ops.lightning.get_lights)
assert curves() == before, "keys changed without an edit"

# Lightning: other keys of the key light's power, keys of the spot, a new light with keys; the disc's keys are removed.
text = FILE.read_text(encoding="utf-8")
FILE.write_text(text.replace("\nshot {", '\nlight rim rect { at 0 2 -5 direction 0 0 1 intensity 3 attenuation 0 0 1 width 2 }\nshot {'),
                encoding="utf-8")
replace_keys("""
  light Key { intensity { 1 2 smooth  6 8 smooth  12 3 } exposure { 3 0  9 2 stepped  12 -1 } }
  light Spot {
    at { 1 0 5 4  12 3 6 2 }
    direction { 1 0 -1 0.2 smooth  6 0.5 -1 0  12 1 -1 -1 }
    angle { 1 20  10 40 }
    on { 1 no  4 yes  9 no }
    color { 1 1 0 0  12 0 0 1 }
  }
  light rim { at { 1 0 2 -5  8 4 2 -5 } intensity { 2 1  10 6 } width { 1 2  12 3 } }
""")
call(bpy.ops.lightning.get_lights)
assert_same("edited")
assert not any(path == "size" and "Disc" in name for name, path, _, _ in curves()), "removed keys stay"
linear = [keys for name, path, _, keys in curves() if path == "spot_size"]
assert len(linear) == 1 and 2 <= len(linear[0]) <= 12, linear
after = curves()
call(bpy.ops.lightning.get_lights)
assert curves() == after, "the same keys came back differently"

# Back in Lightning, all frames are the same, up to Blender's single precision.
call(bpy.ops.lightning.send)
assert_same("sent again")
call(bpy.ops.lightning.get_lights)
assert curves() == after

# A light with a parent keeps its keys of the position.
disc.parent = bpy.data.objects["Cube"]
bpy.context.view_layer.update()
call(bpy.ops.lightning.send)
text = FILE.read_text(encoding="utf-8")
FILE.write_text(text.rstrip().removesuffix("}") + "  light Disc { at { 1 0 5 4  12 3 6 2 } radius { 1 1  12 3 } }\n}\n", encoding="utf-8")
call(bpy.ops.lightning.get_lights)
assert disc.animation_data is None or not any(path == "location" and "Disc" in name for name, path, _, _ in curves())
assert any(path == "size" and "Disc" in name for name, path, _, _ in curves())
disc.parent = None

# Lights with nodes: color and strength of the only Emission node change; other nodes are said.
def add_nodes(obj):
    """Gives a light an Emission node; returns it."""
    obj.data.use_nodes = True
    node = obj.data.node_tree.nodes["Emission"]
    node.inputs["Color"].default_value, node.inputs["Strength"].default_value = (1, 0, 0, 1), 3
    return node


emission = add_nodes(key)
color, energy = tuple(key.data.color), key.data.energy
textured = add_nodes(bpy.data.objects["Square"])
texture = textured.id_data.nodes.new("ShaderNodeTexChecker")
textured.id_data.links.new(texture.outputs["Color"], textured.inputs["Color"])
call(bpy.ops.lightning.send)
assert_same("nodes")
replace_keys("light Spot { on { 1 no  4 yes } }\n")
sample.set_in_file(FILE, "Key.color=0 0.5 1", "Key.intensity=1.5")
call(bpy.ops.lightning.get_lights)
assert_same("edited nodes")
assert tuple(key.data.color) == color and key.data.energy == energy and emission.inputs["Color"].default_value[0] == 0
replace_keys("light Key { intensity { 1 1  5 7 smooth  12 2 } color { 1 1 1 0  12 0.5 0 1 } }\n")
call(bpy.ops.lightning.get_lights)
assert_same("keyed nodes")
assert any("inputs" in path for _, path, _, _ in curves())

# Keys of a light group become keys of its lights; the camera and objects get theirs.
call(bpy.ops.lightning.send)
text = FILE.read_text(encoding="utf-8")
assert "light Spot spot {" in text, text
FILE.write_text(text.replace("\nshot {", "\nbank fills { }\nshot {").replace("light Spot spot {", "light Spot spot { bank fills"), encoding="utf-8")
cube = bpy.data.objects["Cube"]
replace_keys("""
  bank fills { intensity { 1 1  12 3 } color { 1 1 1 1  12 1 0.5 0 } on { 1 yes  5 no  9 yes } }
  camera { from { 1 7 5 7  12 5 6 7 smooth } to { 1 0 0 0  12 1 0 0 } fov { 1 30  12 50 } shift { 1 0 0  12 0.2 -0.1 } }
  mesh Cube { at { 1 0 0 0  12 3 4 5 } rotate { 1 0 0 0  12 20 400 0 } scale { 1 1 1 1  12 1 2 1 } }
""")
messages = transfer.get_lights(bpy.context, FILE)
assert not any("stay in Lightning" in m and ("group" in m or "Cube" in m) for m in messages), messages
target = sample.FOLDER / "lights.json"
sample.run_program("export-lights", str(FILE), "-o", str(target), "--quiet")
root = json.loads(target.read_text(encoding="utf-8"))
tracks = root["shot"]["tracks"]
matrices = next(t["matrices"] for t in tracks if t.get("node") == "Cube")
view = {t["attribute"]: t["values"] for t in tracks if "camera" in t}


def near(ours, theirs, what) -> None:
    assert all(abs(a - b) <= PRECISION * max(1, abs(b)) for a, b in zip(ours, theirs, strict=True)), (what, ours, theirs)


spot_light = next(light for light in root["lights"] if light["name"] == "Spot")
for i in range(12):
    scene.frame_set(i + 1)
    near(axes.columns(cube.matrix_world), matrices[i], f"Cube at {i + 1}")
    seen = shot.camera(scene)
    near(seen["from"], view["from"][i], "camera")
    near([seen["fov"]], [view["fov"][i]], "field of view")
    near(seen["shift"], view["shift"][i], "lens shift")
    near(Vector(seen["to"]) - Vector(seen["from"]), (Vector(view["to"][i]) - Vector(view["from"][i])).normalized() *
         (Vector(seen["to"]) - Vector(seen["from"])).length, "direction")
    at = lights.describe(spot, {}, [])
    assert at["on"] == (not 5 <= i + 1 < 9 and spot_light["on"]), (i, at["on"])
    near([at["intensity"]], [spot_light["relative_intensity"] * (1 + 2 * i / 11)], "group")
    near(at["color"], [c * g for c, g in zip(spot_light["color"], (1, 1 - i / 22, 1 - i / 11))], "color of the group")
scene.frame_set(4)
after = curves()
transfer.get_lights(bpy.context, FILE)
assert curves() == after, "the same keys came back differently"
messages = []
lights.describe(bpy.data.objects["Square"], {}, messages)
assert "except for an image of an area light" in messages[0], messages
emission.id_data.links.remove(emission.outputs[0].links[0])
mix = emission.id_data.nodes.new("ShaderNodeMixShader")
emission.id_data.links.new(mix.outputs[0], emission.id_data.get_output_node("ALL").inputs["Surface"])
messages = []
lights.describe(key, {}, messages)
assert "other shaders" in messages[0], messages
print("all keys are equal")
