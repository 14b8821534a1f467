"""Edits a scene while the live view runs: each picture equals, in every bit, a render of the scene that is sent again.

Arguments: a folder, "small" or "large" pictures, and to measure only, a number of objects.
"""

import math
import shutil
import sys
import time
from pathlib import Path

import blender_scene as sample
import bpy
import numpy

IS_LARGE = sys.argv[2] == "large"
WIDTH, HEIGHT = (96, 54) if IS_LARGE else (32, 18)


def pixels(image):
    """Returns an image's colors."""
    values = numpy.empty(image.size[0] * image.size[1] * 4, dtype=numpy.float32)
    image.pixels.foreach_get(values)
    return values.reshape(image.size[1], image.size[0], 4)


def follow() -> None:
    """Lets Blender update and the live view follow."""
    bpy.context.view_layer.update()
    view = live.view()
    end = time.monotonic() + 60
    while not view.is_idle():
        view.pump()
        time.sleep(0.0005)
        assert time.monotonic() < end, view.status
    assert not view.error, view.error


def sent(name: str):
    """Returns a full trace of the scene that is sent again; for some edits with the button, objects then remember what was sent."""
    target = sample.FOLDER / "again.jen"
    fields = {"file": str(target)}
    if name in ("start", "several"):
        transfer.send(bpy.context, target, True)
    elif name in ("glass", "object, light, material and world", "object with a texture"):
        program.run(*transfer.prepare(bpy.context, target, []))
    else:
        # The server imports as the command does, without the start of a process.
        transfer.prepare(bpy.context, target, [])
        fields = {"file": str(target.with_suffix(".glb")), "output": str(sample.FOLDER / f"{time.monotonic_ns()}" / "again.jen"), "indirect": "off"}
        shutil.copytree(sample.FOLDER, Path(fields["output"]).parent, ignore=lambda folder, names: [
            n for n in names if not n.startswith(("again-", "light-")) and not n.endswith(".ies")])
    number = reference.request("open", **fields)["scene"]
    memory = reference.request("render", scene=number, memory=True)["memory"]
    result = numpy.fromfile(memory["path"], dtype="<f4").reshape(memory["shape"])[::-1]
    reference.request("close", scene=number)
    return result


def check(name: str, is_sent_again: bool = False) -> None:
    """Lets the live view follow an edit and compares its picture."""
    global before
    count = live.view()._sent
    follow()
    assert (live.view()._sent > count) == is_sent_again, name
    shown = pixels(bpy.data.images["Lightning"])
    expected = sent(name)
    assert shown[:, :, :3].tobytes() == expected.tobytes(), f"{name}: {(shown[:, :, :3] != expected).any(axis=2).sum()} pixels differ"
    assert before is None or before.shape != shown.shape or not numpy.array_equal(shown, before), f"{name}: nothing changed"
    before = shown
    print(f"{name}: equal, {live.view().milliseconds:.1f} ms")


def shader(name: str):
    """Returns a socket of the material."""
    return bpy.data.materials["Material"].node_tree.nodes["Principled BSDF"].inputs[name]


def move_vertex(i: int) -> None:
    """Edits the mesh that two objects show."""
    mesh = bpy.data.objects["Cube"].data
    mesh.vertices[0].co.x = -1 - i / 50
    mesh.update_tag()


def measure(width: int, height: int) -> None:
    """Measures edits: from the change in Blender to the image's pixels."""
    scene.render.resolution_x, scene.render.resolution_y = width, height
    live.view().refresh()
    follow()
    for name, edit in (("color", lambda i: setattr(key.data, "color", (1, 0.5, 0.2 + i / 100))),
                       ("location", lambda i: setattr(key, "location", (1 + i / 50, 2, 3))),
                       ("camera", lambda i: setattr(scene.camera, "location", (7.3 + i / 100, -6.9, 4.9))),
                       ("object", lambda i: setattr(bpy.data.objects["Cube"], "location", (i / 50, 0, 0))),
                       ("material", lambda i: setattr(shader("Base Color"), "default_value", (0.1, 0.6, 0.2 + i / 100, 1))),
                       ("mesh", move_vertex)):
        times, first = [], []
        for i in range(1, 16):
            start = time.perf_counter()
            live.view().coarse_milliseconds = 0
            edit(i)
            follow()
            times.append(1000 * (time.perf_counter() - start))
            first.append(live.view().coarse_milliseconds or times[-1])
        print(f"{width}x{height} {name}: smallest {min(times[4:]):.1f} ms, median {sorted(times[4:])[5]:.1f} ms; "
              f"first picture {min(first[4:]):.1f} ms, median {sorted(first[4:])[5]:.1f} ms")


sample.start()
scene = sample.build()
from bl_ext.user_default.lightning import live, program, transfer  # noqa: E402, after the add-on is enabled
from bl_ext.user_default.lightning.lightning_relight import Client  # noqa: E402

scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
key, spot, box = (bpy.data.objects[name] for name in ("Key", "Spot", "Soft Box"))
def set_reflections(level: float) -> None:
    """Sets how much the material reflects: rough reflections take most of the time of a picture. Large pictures have them always."""
    if not IS_LARGE:
        shader("Specular IOR Level").default_value, shader("Roughness").default_value = level, 1 - level


set_reflections(0)
assert bpy.ops.lightning.live_view() == {"FINISHED"}
before = None
if len(sys.argv) > 3:
    # Measures a scene with so many additional spheres of 960 triangles.
    for n in range(int(sys.argv[3])):
        bpy.ops.mesh.primitive_uv_sphere_add(segments=32, ring_count=16, radius=0.3, location=(n % 10 - 5, n // 10 - 5, -1))
    measure(480, 270)
    measure(960, 540)
    live.stop()
    sys.exit()
# A server of its own costs as much as all small pictures.
reference = Client(program=program.find()) if IS_LARGE else live.view()._client
check("start", True)
key.data.energy = 700
check("energy")
key.data.color = (0.2, 1, 0.4)
check("color")
key.location = (2, 1, 3.5)
check("location")
spot.data.spot_blend = 0.7
spot.data.spot_size = math.radians(61)
check("edge of a spot")
box.data.size, box.data.exposure = 1.25, 0.5
box.rotation_euler[0] = 0.2
check("several")
sample.show_image(box)
check("image of an area light")
sample.show_profile(key)
check("profile of a point light")
sample.show_profile(spot)
check("profile of a spot")
spot.hide_render = True
check("off")
key.data.use_shadow = False
key.data.diffuse_factor = 0.5
key.lightgroup = ""
check("switches")
bpy.data.objects.remove(bpy.data.objects["Disc"])
check("removed")
sample.add_light("SPOT", 'new "one"', (0, -3, 4), (0.6, 0, 0), energy=600, spot_blend=0.4)
check("added")
scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 2
check("strength of the world")
scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.1, 0.02, 0.3, 1)
check("color of the world")
key.data.type = "SUN"
check("type", True)
cube, copy = bpy.data.objects["Cube"], bpy.data.objects["Copy"]
cube.location.x = 0.5
check("moved object")
cube.rotation_euler, cube.scale = (0.3, -0.2, 0.7), (1, 1.25, -1)
check("turned object")
for name, value in (("Base Color", (0.1, 0.6, 0.2, 1)), ("Roughness", 0.15), ("Metallic", 1), ("Metallic", 0), ("Emission Strength", 0.4),
                    ("Emission Color", (7, 2, 0.3, 1)), ("Emission Strength", 0), ("Alpha", 0.3), ("Alpha", 1), ("Base Color", (1, 1, 1, 1)),
                    ("Specular IOR Level", 0.2)):
    if name == "Roughness":
        set_reflections(0.5)
    shader(name).default_value = value
    check(f"{name} {value}", name.startswith("Specular") or name == "Roughness" and not IS_LARGE)
    if (name, value) == ("Metallic", 0) and not IS_LARGE:
        set_reflections(0)
        check("no reflections", True)
shader("IOR").default_value = 1.3
shader("Transmission Weight").default_value = 1
check("glass", True)
shader("IOR").default_value = 1.7
check("index of glass")
shader("Base Color").default_value = (0.9, 0.25, 0.04, 1)
check("color of glass")
shader("Transmission Weight").default_value = 0.5
check("half as much glass", True)
shader("Transmission Weight").default_value = 0
check("no glass", True)
scene.camera.location.z += 0.5
check("camera")
scene.camera.rotation_euler.x += 0.05
scene.camera.data.lens = 35
check("turned camera, lens")
scene.camera.data.sensor_fit = "VERTICAL"
check("sensor")
scene.camera.data.shift_x = 0.1
check("shift of the camera")
cube.location.z, key.rotation_euler.y, copy.scale.y = 0.25, 0.3, 2
shader("Base Color").default_value = (0.8, 0.3, 0.1, 1)
scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0.5
check("object, light, material and world")
copy.rotation_euler = (0, 0, 0)
copy.parent = cube
check("parent")
copy.rotation_euler.x = 0.5
check("sheared child", True)
copy.rotation_euler.x = 0
check("child that is not sheared", True)
cube.location.y = -0.4
check("object with a child")
cube.data.vertices[0].co.x -= 0.5
cube.data.update_tag()
check("mesh", True)
cube.location.y = 0
check("object of the new mesh")
# Not a bevel: its texture coordinates differ from export to export.
cube.modifiers.new("Subdivision", "SUBSURF").levels = 1
check("modifier", True)
copy.hide_render = True
check("hidden object", True)
copy.hide_render = False
check("shown object", True)
tree = bpy.data.materials["Material"].node_tree
image = bpy.data.images.new("Texture", 4, 4)
image.generated_type = "COLOR_GRID"
texture = tree.nodes.new("ShaderNodeTexImage")
texture.image = image
tree.links.new(texture.outputs["Color"], shader("Base Color"))
set_reflections(0.5)
check("texture", True)
shader("Roughness").default_value = 0.6
check("roughness with a texture")
cube.location.x = -0.2
check("object with a texture")
tree.links.remove(tree.links[-1])
set_reflections(0)
check("no texture", True)
# Instances of a collection, and lights in them; geometry nodes.
inner = bpy.data.collections.new("inner")
pot, bulb = bpy.data.objects.new("Pot", cube.data), bpy.data.objects.new("Bulb", bpy.data.lights.new("Bulb", "POINT"))
pot.scale, bulb.location, bulb.data.energy = (0.3, 0.3, 0.3), (0, 0, 1), 300
inner.objects.link(pot)
pots = bpy.data.objects.new("Pots", None)
pots.instance_type, pots.instance_collection, pots.location = "COLLECTION", inner, (-2, -2, 0)
scene.collection.objects.link(pots)
check("instance of a collection", True)
pots.location.y = -2.5
check("moved instance")
inner.objects.link(bulb)
check("light in an instance", True)
bulb.data.energy = 600
check("energy of a light in an instance")
bulb.location.x = -0.5
check("moved light in an instance", True)
pots.rotation_euler.z = 0.5
check("turned instance with a light", True)
pot.location.z = 0.2
check("moved object in an instance", True)
pot.hide_render = True
check("hidden object in an instance", True)
pot.hide_render = False
check("shown object in an instance", True)
tree = bpy.data.node_groups.new("nodes", "GeometryNodeTree")
for in_out in ("INPUT", "OUTPUT"):
    tree.interface.new_socket("Geometry", in_out=in_out, socket_type="NodeSocketGeometry")
start, end, put, ball = (tree.nodes.new(kind) for kind in ("NodeGroupInput", "NodeGroupOutput", "GeometryNodeInstanceOnPoints",
                                                           "GeometryNodeMeshIcoSphere"))
ball.inputs["Radius"].default_value = 0.2
for socket, to in ((start.outputs[0], put.inputs["Points"]), (ball.outputs["Mesh"], put.inputs["Instance"]), (put.outputs[0], end.inputs[0])):
    tree.links.new(socket, to)
scatter = bpy.data.objects.new("Scatter", cube.data.copy())
scatter.location, scatter.scale = (2, -2, 0), (0.5, 0.5, 0.5)
scene.collection.objects.link(scatter)
scatter.modifiers.new("nodes", "NODES").node_group = tree
check("geometry nodes", True)
scatter.location.z = 0.5
check("moved geometry nodes", True)
bulb.hide_render = True
check("hidden light in an instance", True)
cube.visible_camera = False
check("hidden from the camera", True)
cube.visible_camera = True
check("seen by the camera", True)
for i in range(20):
    # A drag: the last edit counts.
    bpy.data.objects["Square"].location.x = 3 - i / 10
    bpy.context.view_layer.update()
    live.view().pump()
check("drag")
# A newer edit cancels the exact picture once a coarse one is shown.
scene.render.resolution_x, scene.render.resolution_y = 10 * WIDTH, 10 * HEIGHT
live.view().refresh()
follow()
# The last exact picture of this kind took long.
scene.camera.location.x += 0.01
follow()
count, shown = live.view().pictures, 0
for i in range(5):
    scene.camera.location.x += 0.01
    bpy.context.view_layer.update()
    live.view().coarse_milliseconds = 0
    end = time.monotonic() + 60
    while not live.view().coarse_milliseconds and not live.view().is_idle():
        live.view().pump()
        assert time.monotonic() < end, live.view().status
    coarse = pixels(bpy.data.images["Lightning"])
    shown += live.view().coarse_milliseconds > 0
assert shown == 5 and live.view().pictures < count + 5, (shown, live.view().pictures - count)
assert coarse.shape == (10 * HEIGHT, 10 * WIDTH, 4) and not numpy.array_equal(coarse, before)
check("drag of the camera with coarse pictures")
if IS_LARGE:
    reference.close()
# Stopped and started; then the server dies, and another file is loaded.
scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
bpy.ops.lightning.live_view()
assert live.view() is None and bpy.app.handlers.depsgraph_update_post == []
assert bpy.ops.lightning.live_view() == {"FINISHED"}
follow()
process = live.view()._client._process
process.kill()
process.wait()
key.data.energy = 5
bpy.context.view_layer.update()
end = time.monotonic() + 10
while not live.view().error:
    live.view().pump()
    assert time.monotonic() < end
print(live.view().status)
assert bpy.ops.wm.read_factory_settings(use_empty=True) == {"FINISHED"}
assert live.view() is None
print("all pictures are equal")
