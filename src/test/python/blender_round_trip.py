"""Sends a scene with every kind of light to Lightning, edits its lights there, and gets them back."""

import blender_scene as sample
import bpy

FILE = str(sample.FOLDER / "shot.jen")
# Single precision, once more after a conversion there and back.
PRECISION = 2e-6


def lights() -> dict:
    return {obj.name: sample.values(obj) for obj in bpy.context.view_layer.objects if obj.type == "LIGHT"}


def call(operator, **arguments) -> None:
    assert operator(filepath=FILE, **arguments) == {"FINISHED"}
    bpy.context.view_layer.update()


def scene_text() -> str:
    """Returns the scene file without the record of the files next to it: the model has more settings when it is sent again."""
    lines = open(FILE, encoding="utf-8").read().splitlines()
    assert any(line.startswith("# wrote: ") for line in lines)
    return "\n".join(line for line in lines if not line.startswith("# wrote: "))


sample.start()
sample.build()
sent = lights()
call(bpy.ops.lightning.send)
text = scene_text()
assert "size 480 270" in text, text

# Nothing was edited: every number keeps its bits.
call(bpy.ops.lightning.get_lights)
assert lights() == sent
call(bpy.ops.lightning.send)
assert scene_text() == text

# Into another file of Blender, where all lights are new.
for obj in [o for o in bpy.data.objects if o.type == "LIGHT"]:
    bpy.data.objects.remove(obj)
call(bpy.ops.lightning.get_lights)
received = lights()
assert received.keys() == sent.keys(), received.keys()
for name, light in sent.items():
    # A spot's edge is a profile in Lightning, which a new light does not have.
    expected = light | {"spot_blend": received[name]["spot_blend"]} if "spot_blend" in light else light
    sample.assert_same(received[name], expected, name, PRECISION)

# Edited in Lightning: changed, switched off and on, added, deleted.
edits = ["--set", "Key.intensity=2", "--set", "Key.at=0 5 0", "--set", "Spot.on=no", "--set", "Sun.on=yes",
         "--set", "Disc.radius=1", "--set", "Soft Box.illuminates=only \"Cube\"", "--set", "keys.intensity=0.5",
         "--set", "world.intensity=0.2", "--set", "world.rotation=-45", "--delete", "Square",
         "--add", "rim rect intensity=4 at=0 2 -5 direction=0 0 1 width=2 height=3 falloff=inverse_square"]
sample.edit_file(FILE, *edits)
try:
    bpy.ops.lightning.send(filepath=FILE)
    raise AssertionError("a scene that was edited was overwritten")
except RuntimeError as e:
    assert "get its lights first" in str(e), e
call(bpy.ops.lightning.get_lights)
edited = lights()
pi = 3.141592653589793
expected = {name: dict(light) for name, light in received.items() if name != "Square"}
expected["Key"] |= {"energy": 2 * 0.5 * 4 * pi ** 2, "location": [0.0, 0.0, 5.0]}
expected["Spot"]["off"], expected["Sun"]["off"] = True, False
expected["Disc"]["extent"] = [2.0, 2.0]
expected["Soft Box"]["receiver_collection"] = [("Cube", "INCLUDE")]
assert edited.keys() == expected.keys() | {"rim"}, edited.keys()
for name, light in expected.items():
    sample.assert_same(edited[name], light, name, PRECISION)
rim = edited["rim"]
sample.assert_same({k: rim[k] for k in ("energy", "extent", "location", "off")},
                   {"energy": 4 * pi ** 2, "extent": [2.0, 3.0], "location": [0.0, 5.0, 2.0], "off": False}, "rim", PRECISION)

# The light group's fader stays Lightning's.
call(bpy.ops.lightning.send)
assert "bank keys { intensity 0.5 }" in open(FILE, encoding="utf-8").read()
bpy.context.view_layer.objects["Key"].data.energy *= 2
call(bpy.ops.lightning.send)
words = open(FILE, encoding="utf-8").read().split("light Key", 1)[1].split()
assert abs(float(words[words.index("intensity") + 1]) - 4) <= 4 * PRECISION

# The world's strength follows Lightning's intensity: one color, whose brightest channel has 255 steps.
strength = bpy.context.scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value
assert abs(strength * 0.05087608844041824 * 256 / 255 - 0.2) <= PRECISION, strength
# An image and a profile in a light's nodes.
disc, key = (bpy.context.view_layer.objects[name] for name in ("Disc", "Key"))
sample.show_image(disc)
sample.show_profile(key)
key.data.energy = 2
call(bpy.ops.lightning.send)
text = open(FILE, encoding="utf-8").read()
assert 'texture "light-colors.hdr"' in text and 'profile "lamp.ies"' in text, text
expected = lights()
sample.set_in_file(FILE, "Key.exposure=2.5", "Disc.color=1 0.5 0.25")
call(bpy.ops.lightning.get_lights)
expected["Key"]["exposure"], expected["Disc"]["color"] = 2.5, [1.0, 0.5, 0.25]
for name, light in expected.items():
    sample.assert_same(lights()[name], light, name, PRECISION)
call(bpy.ops.lightning.send)
assert 'texture "light-colors.hdr"' in open(FILE, encoding="utf-8").read()
for light in (disc, key):
    tree = light.data.node_tree
    for link in [link for link in tree.links if link.to_node == tree.nodes["Emission"]]:
        tree.links.remove(link)
call(bpy.ops.lightning.send)
assert "texture" not in (text := open(FILE, encoding="utf-8").read()) and "lamp.ies" not in text, text
print("all lights are equal")
