"""Edits a scene while the live view runs: each picture equals, in every bit, a render of the scene that is sent anew."""

import math
import sys
import time

import blender_scene as sample
import bpy
import numpy


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


def sent(has_memory: bool):
    """Returns a full trace of the scene that is sent anew; with `has_memory`, objects then remember what was sent."""
    target = sample.FOLDER / "anew.jen"
    if has_memory:
        transfer.send(bpy.context, target, True)
    else:
        program.run(*transfer.prepare(bpy.context, target, []))
    number = reference.request("open", file=str(target))["scene"]
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
    expected = sent(name in ("start", "several"))
    assert shown[:, :, :3].tobytes() == expected.tobytes(), f"{name}: {(shown[:, :, :3] != expected).any(axis=2).sum()} pixels differ"
    assert before is None or before.shape != shown.shape or not numpy.array_equal(shown, before), f"{name}: nothing changed"
    before = shown
    print(f"{name}: equal, {live.view().milliseconds:.1f} ms")


def measure(width: int, height: int) -> None:
    """Measures edits: from the change in Blender to the image's pixels."""
    scene.render.resolution_x, scene.render.resolution_y = width, height
    live.view().refresh()
    follow()
    for name, edit in (("color", lambda i: setattr(key.data, "color", (1, 0.5, 0.2 + i / 100))),
                       ("location", lambda i: setattr(key, "location", (1 + i / 50, 2, 3)))):
        times = []
        for i in range(40):
            start = time.perf_counter()
            edit(i)
            follow()
            times.append(1000 * (time.perf_counter() - start))
        print(f"{width}x{height} {name}: smallest {min(times[5:]):.1f} ms, median {sorted(times[5:])[17]:.1f} ms")


sample.start()
scene = sample.build()
from bl_ext.user_default.lightning import live, program, transfer  # noqa: E402, after the add-on is enabled
from bl_ext.user_default.lightning.lightning_relight import Client  # noqa: E402

scene.render.resolution_x, scene.render.resolution_y = 96, 54
key, spot, box = (bpy.data.objects[name] for name in ("Key", "Spot", "Soft Box"))
assert bpy.ops.lightning.live_view() == {"FINISHED"}
before = None
if len(sys.argv) > 2:
    measure(480, 270)
    measure(960, 540)
    live.stop()
    sys.exit()
reference = Client(program=program.find())
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
bpy.data.objects["Cube"].location.x = 0.5
check("moved object", True)
bpy.data.materials["Material"].node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (0.1, 0.6, 0.2, 1)
check("material", True)
scene.camera.location.z += 0.5
check("camera", True)
for i in range(20):
    # A drag: the last edit counts.
    bpy.data.objects["Square"].location.x = 3 - i / 10
    bpy.context.view_layer.update()
    live.view().pump()
check("drag")
reference.close()
# Stopped and started; then the server dies, and another file is loaded.
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
