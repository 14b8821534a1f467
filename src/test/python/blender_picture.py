"""Sends a scene to Lightning, edits its picture there and in Blender, and looks at the settings on both sides."""

import blender_scene as sample
import bpy

FILE = sample.FOLDER / "shot.jen"


def edit(*edits: str) -> None:
    """Edits the scene file, and gets it back."""
    sample.set_in_file(FILE, *edits)
    assert bpy.ops.lightning.get_lights(filepath=str(FILE)) == {"FINISHED"}


def sent() -> str:
    """Sends the scene; returns its file."""
    assert bpy.ops.lightning.send(filepath=str(FILE)) == {"FINISHED"}
    return FILE.read_text(encoding="utf-8")


sample.start()
scene = sample.build()
from bl_ext.user_default.lightning import transfer  # noqa: E402, after the add-on is enabled

assert "indirect" not in sent()
# What Blender has too comes back.
edit("picture.exposure=1.5", "picture.view=filmic", "picture.size=40 30", "picture.depth=7", "picture.indirect.bounces=3")
assert scene.lightning_indirect == "ON"
assert (scene.render.resolution_x, scene.render.resolution_y) == (40, 30)
assert (scene.view_settings.exposure, scene.view_settings.view_transform) == (1.5, "Filmic")
# What only Lightning has survives the next sending, beside an edit in Blender.
scene.view_settings.exposure = -1
text = sent()
for setting in ("size 40 30", "depth 7", "view filmic", "exposure -1", "bounces 3", "antialias edges"):
    assert setting in text, (setting, text)
edit("picture.indirect=none")
assert scene.lightning_indirect == "OFF" and "indirect" not in sent()
scene.lightning_indirect = "ON"
assert "indirect" in sent()
# The camera in a closed room.
scene.lightning_indirect = "AUTO"
bpy.ops.mesh.primitive_cube_add(size=100)
assert "the camera is in a closed room, so indirect light is on" in transfer.send(bpy.context, FILE)
assert "indirect" in FILE.read_text(encoding="utf-8")
# The bounces of Blender's engine, also in the open.
bpy.data.objects.remove(bpy.context.object)
scene.render.engine = "CYCLES"
scene.cycles.diffuse_bounces = 3
assert "indirect light is on with 3 bounces, as in Cycles" in transfer.send(bpy.context, FILE)
assert "bounces 3" in FILE.read_text(encoding="utf-8")
scene.cycles.diffuse_bounces = 20
assert "indirect light is on with 8 bounces, as in Cycles, which has 12" in transfer.send(bpy.context, FILE)
scene.cycles.diffuse_bounces = 0
assert "indirect light is off, because Cycles has no diffuse bounces" in transfer.send(bpy.context, FILE)
assert "indirect" not in FILE.read_text(encoding="utf-8")
scene.render.engine = "BLENDER_EEVEE"
scene.eevee.use_raytracing = True
assert "indirect light is on with 4 bounces, as in EEVEE with ray tracing" in transfer.send(bpy.context, FILE)
scene.eevee.use_raytracing = False
assert not [line for line in transfer.send(bpy.context, FILE) if "indirect" in line]
print("the picture is equal")
