"""Rotates an environment in Lightning about three axes, gets it, and sends it back."""

import math

import blender_scene as sample
import bpy

FILE = str(sample.FOLDER / "sky.jen")


def assert_near(rotation: float, tilt: float, roll: float) -> None:
    """Compares the angles of the environment in the scene file, degrees."""
    words = open(FILE, encoding="utf-8").read().split()
    for name, angle in {"rotation": rotation, "tilt": tilt, "roll": roll}.items():
        found = float(words[words.index(name) + 1]) if name in words else 0
        assert abs(found - angle) < 1e-4, (name, found, angle)


sample.start()
tree = bpy.context.scene.world.node_tree
texture = tree.nodes.new("ShaderNodeTexEnvironment")
texture.image = bpy.data.images.new("sky", 8, 4, float_buffer=True)
tree.links.new(texture.outputs["Color"], tree.nodes["Background"].inputs["Color"])
bpy.ops.lightning.send(filepath=FILE)
assert_near(-90, 0, 0)

sample.set_in_file(FILE, "world.rotation=40", "world.tilt=-25", "world.roll=10")
bpy.ops.lightning.get_lights(filepath=FILE)
bpy.ops.lightning.send(filepath=FILE)
assert_near(40, -25, 10)

# A level sky forgets the tilt.
mapping = texture.inputs["Vector"].links[0].from_node
mapping.inputs["Rotation"].default_value = (0, 0, math.radians(-30))
bpy.ops.lightning.send(filepath=FILE)
assert_near(-60, 0, 0)
print("the sky is equal")
