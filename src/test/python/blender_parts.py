"""Sends materials, instances, a camera and animation to Lightning; writes what Blender has at each frame for comparison."""

import json
import math

import blender_scene as sample
import bpy
from bpy_extras.object_utils import world_to_camera_view

sample.start()
scene = bpy.context.scene
cube = bpy.data.objects["Cube"]


def material(name: str, **inputs):
    """Adds a principled material."""
    result = bpy.data.materials.new(name)
    for key, value in inputs.items():
        result.node_tree.nodes["Principled BSDF"].inputs[key.replace("_", " ")].default_value = value
    return result


def ball(name: str, location, shown) -> None:
    """Adds a closed mesh."""
    bpy.ops.mesh.primitive_uv_sphere_add(segments=8, ring_count=6, location=location)
    bpy.context.object.name = name
    bpy.context.object.data.materials.append(shown)


def picture(name: str, alpha: bool = False):
    """Returns an image with some pattern."""
    result = bpy.data.images.new(name, 4, 4, alpha=alpha)
    result.pixels = [((i * 7) % 11) / 11 for i in range(64)]
    result.pack()
    return result


def link(to, node_name: str, image, socket: str, output: str = "Color"):
    """Links an image to a socket of a material."""
    tree = to.node_tree
    node = tree.nodes.new("ShaderNodeTexImage")
    node.image = image
    tree.links.new(node.outputs[output], tree.nodes[node_name].inputs[socket])
    return node


water = material("water", Transmission_Weight=1, IOR=1.33, Roughness=0, Base_Color=(1, 0.36, 0.09, 1))
absorption = water.node_tree.nodes.new("ShaderNodeVolumeAbsorption")
absorption.inputs["Color"].default_value = (0.25, 0.5, 1, 1)
absorption.inputs["Density"].default_value = 2
water.node_tree.links.new(absorption.outputs[0], water.node_tree.nodes["Material Output"].inputs["Volume"])
ball("Drop", (3, 0, 0), water)
crystal = material("crystal")
glass = crystal.node_tree.nodes.new("ShaderNodeBsdfGlass")
glass.inputs["Color"].default_value, glass.inputs["IOR"].default_value, glass.inputs["Roughness"].default_value = (1, 0.5, 0.25, 1), 1.7, 0
crystal.node_tree.links.new(glass.outputs[0], crystal.node_tree.nodes["Material Output"].inputs["Surface"])
ball("Crystal", (6, 0, 0), crystal)
bpy.ops.mesh.primitive_plane_add(location=(0, 4, 0))
bpy.context.object.name = "Pane"
bpy.context.object.data.materials.append(material("pane", Transmission_Weight=1, IOR=1.5, Roughness=0))
wall = material("wall", Metallic=0.25, Roughness=0.75)
link(wall, "Principled BSDF", picture("bricks"), "Base Color")
normal = wall.node_tree.nodes.new("ShaderNodeNormalMap")
normal.name = "normals"
normal.inputs["Strength"].default_value = 0.5
bumps = picture("bumps")
bumps.colorspace_settings.name = "Non-Color"
link(wall, "normals", bumps, "Color")
wall.node_tree.links.new(normal.outputs[0], wall.node_tree.nodes["Principled BSDF"].inputs["Normal"])
cube.data.materials[0] = wall
leaf = material("leaf", Emission_Color=(1, 0.5, 0, 1), Emission_Strength=2)
pattern = link(leaf, "Principled BSDF", picture("leaves", True), "Base Color")
leaf.node_tree.links.new(pattern.outputs["Alpha"], leaf.node_tree.nodes["Principled BSDF"].inputs["Alpha"])
bpy.ops.mesh.primitive_plane_add(location=(0, -4, 0))
bpy.context.object.name = "Leaf"
bpy.context.object.data.materials.append(leaf)

# An instance below a moved and turned parent, and a mesh of two materials.
parent = bpy.data.objects.new("Parent", None)
scene.collection.objects.link(parent)
copy = bpy.data.objects.new("Copy", cube.data)
copy.parent, copy.location, copy.scale = parent, (2, 0, 1), (0.5, 0.5, 1)
scene.collection.objects.link(copy)
bpy.ops.mesh.primitive_cube_add(location=(-4, 0, 0))
both = bpy.context.object
both.name = "Both"
both.data.materials.append(wall)
both.data.materials.append(leaf)
both.data.polygons[0].material_index = 1

# What a render does not show: an object of an excluded collection, and one that is switched off. Their lights are off.
excluded = bpy.data.collections.new("excluded")
scene.collection.children.link(excluded)
excluded.objects.link(bpy.data.objects.new("Excluded", cube.data))
away = sample.add_light("POINT", "Away", (1, 2, 3))
scene.collection.objects.unlink(away)
excluded.objects.link(away)
bpy.context.view_layer.layer_collection.children["excluded"].exclude = True
off = bpy.data.objects.new("Off", cube.data)
off.hide_render = True
scene.collection.objects.link(off)

# Instances of a collection.
collection = bpy.data.collections.new("pots")
collection.objects.link(bpy.data.objects.new("Pot", cube.data))
for x in (20, 30):
    empty = bpy.data.objects.new("Pots", None)
    empty.instance_type, empty.instance_collection, empty.location = "COLLECTION", collection, (x, 0, 0)
    scene.collection.objects.link(empty)

# A second camera is active, in a portrait picture; everything moves.
data = bpy.data.cameras.new("Closeup")
data.lens = 70
camera = bpy.data.objects.new("Closeup", data)
scene.collection.objects.link(camera)
camera.location, camera.rotation_euler = (2, -9, 3), (1.3, 0, 0.2)
scene.camera = camera
scene.render.resolution_x, scene.render.resolution_y = 200, 320
scene.render.fps, scene.frame_start, scene.frame_end = 25, 5, 16
light = bpy.data.objects["Light"]
light.light_linking.receiver_collection = sample.linked("INCLUDE", both)
for frame, turn in ((5, 0.0), (16, 6.0)):
    parent.rotation_euler = (0.3, turn / 2, turn)
    parent.location = (0, 0, turn / 3)
    both.rotation_euler = (turn, 0, 0.5)
    camera.location.x = 2 + turn / 6
    data.lens = 70 - 2 * turn
    data.shift_x, data.shift_y = 0.25 - turn / 20, 0.3 + turn / 40
    light.location.z = 5 + turn
    light.data.color = (1, 1 - turn / 12, 0.5)
    for obj, path in ((parent, "rotation_euler"), (parent, "location"), (both, "rotation_euler"), (camera, "location"), (data, "lens"), (data, "shift_x"), (data, "shift_y"),
                      (light, "location"), (light.data, "color")):
        obj.keyframe_insert(path, frame=frame)
light.hide_render = True
light.keyframe_insert("hide_render", frame=10)
light.hide_render = False
light.keyframe_insert("hide_render", frame=5)

assert bpy.ops.lightning.send(filepath=str(sample.FOLDER / "parts.jen")) == {"FINISHED"}


def world(obj) -> list:
    """Returns columns in Lightning's axes: x right, y up, z back."""
    m = obj.matrix_world
    rows, columns, signs = (0, 2, 1), (0, 2, 1), (1, 1, -1)
    result = [[signs[r] * signs[c] * m[rows[r]][columns[c]] for r in range(3)] for c in range(3)]
    return result + [[m[0][3], m[2][3], -m[1][3]]]


frames = {}
for frame in range(5, 17):
    scene.frame_set(frame)
    seen = world_to_camera_view(scene, camera, copy.matrix_world.translation)
    # The angle of the longer side, which is the height.
    frames[frame] = {"Copy": world(copy), "Both": world(both), "camera": world(camera), "fov": math.degrees(data.angle),
                     "Light": world(light), "point": world(copy)[3], "seen": list(seen), "on": not light.hide_render, "color": list(light.data.color)}
(sample.FOLDER / "frames.json").write_text(json.dumps(frames), encoding="utf-8")
print("sent")
