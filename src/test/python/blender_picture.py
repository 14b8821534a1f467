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
print("the picture is equal")
