"""Sends a scene to Lightning, edits objects and materials there, and gets them back."""

import blender_scene as sample
import bpy

FILE = sample.FOLDER / "shot.jen"
PRECISION = 4e-6


def edit(*edits: str) -> list[str]:
    """Edits the scene file, and gets it back; returns the messages."""
    sample.set_in_file(FILE, *edits)
    messages = transfer.get_lights(bpy.context, FILE)
    bpy.context.view_layer.update()
    return messages


def state(obj) -> list:
    return [tuple(row) for row in obj.matrix_world] + [obj.hide_render, obj.rotation_mode]


def assert_near(ours, theirs, what) -> None:
    assert all(abs(a - b) <= PRECISION * max(1, abs(b)) for a, b in zip(ours, theirs, strict=True)), (what, tuple(ours), theirs)


sample.start()
scene = sample.build()
from bl_ext.user_default.lightning import transfer  # noqa: E402, after the add-on is enabled

cube, copy = bpy.data.objects["Cube"], bpy.data.objects["Copy"]
material = cube.active_material
shader = next(node for node in material.node_tree.nodes if node.bl_idname == "ShaderNodeBsdfPrincipled")
scene.frame_start, scene.frame_end = 1, 12
for frame, place in ((1, (0, 0, 0)), (12, (1, 0, 0))):
    cube.location = place
    cube.keyframe_insert("location", frame=frame)
scene.frame_set(1)
assert bpy.ops.lightning.send(filepath=str(FILE)) == {"FINISHED"}

# Without an edit, every bit stays.
before = [state(obj) for obj in scene.objects], [tuple(shader.inputs[name].default_value) if name == "Base Color" else shader.inputs[name].default_value
                                                 for name in ("Base Color", "Metallic", "Roughness", "IOR")]
transfer.get_lights(bpy.context, FILE)
assert before == ([state(obj) for obj in scene.objects], [tuple(shader.inputs[name].default_value) if name == "Base Color" else
                                                           shader.inputs[name].default_value for name in ("Base Color", "Metallic", "Roughness", "IOR")])

# Placements of an object without keys, and values of its material.
edit("Copy.at=1 2 3", "Copy.scale=1 2 3", f"{material.name}.base=0.1 0.2 0.3", f"{material.name}.metalness=0.75",
     f"{material.name}.roughness=0.25", f"{material.name}.glow=2 1 0", f"{material.name}.coat=0.5",
     f"{material.name}.coat_roughness=0.125", f"{material.name}.coat_ior=1.75",
     f"{material.name}.sheen=0.5 0.25 0", f"{material.name}.sheen_roughness=0.375",
     f"{material.name}.anisotropy=0.5", f"{material.name}.anisotropy_rotation=90")
assert_near(copy.location, (1, -3, 2), "location")
assert_near(copy.scale, (1, 3, 2), "scale")
assert_near(shader.inputs["Base Color"].default_value, (0.1, 0.2, 0.3, 1), "base color")
assert_near([shader.inputs[name].default_value for name in ("Metallic", "Roughness", "Emission Strength")], (0.75, 0.25, 2), "values")
assert_near(shader.inputs["Emission Color"].default_value, (1, 0.5, 0, 1), "emission")
assert_near([shader.inputs[name].default_value for name in ("Coat Weight", "Coat Roughness", "Coat IOR")], (0.5, 0.125, 1.75), "coat")
assert_near([*shader.inputs["Sheen Tint"].default_value, shader.inputs["Sheen Weight"].default_value, shader.inputs["Sheen Roughness"].default_value],
            (1, 0.5, 0, 1, 0.5, 0.375), "sheen")
assert_near([shader.inputs[name].default_value for name in ("Anisotropic", "Anisotropic Rotation")], (0.5, 0.25), "anisotropy")
assert bpy.ops.lightning.send(filepath=str(FILE)) == {"FINISHED"}
assert "coat 0.5" in FILE.read_text(encoding="utf-8") and "coat_ior 1.75" in FILE.read_text(encoding="utf-8"), "coat, sent again"
assert "sheen 0.5 0.25 0\n" in FILE.read_text(encoding="utf-8") and "sheen_roughness 0.375" in FILE.read_text(encoding="utf-8"), "sheen, sent again"
assert transfer.get_lights(bpy.context, FILE) is not None
assert_near(copy.location, (1, -3, 2), "location, sent again")

# Hidden, and another property that a Principled BSDF has elsewhere.
messages = edit("Copy.visible=no", f"{material.name}.f0=0.1")
assert copy.hide_render and not cube.hide_render
assert any(material.name in m and "stay in Lightning: f0" in m for m in messages), messages
copy.hide_render = False
edit("Copy.visible=yes")

# Keys that are deleted in Lightning are deleted in Blender.
text = FILE.read_text(encoding="utf-8")
FILE.write_text(text[:text.index("\nshot {")] + "\nshot {\n  frames 1 12\n  rate 24\n}\n", encoding="utf-8")
transfer.get_lights(bpy.context, FILE)
scene.frame_set(12)
bpy.context.view_layer.update()
assert_near(cube.location, (0, 0, 0), "without keys")

# An object that is renamed counts as deleted and added: Blender's stays, and messages say so.
FILE.write_text(FILE.read_text(encoding="utf-8").replace("Copy", "Other"), encoding="utf-8")
messages = transfer.get_lights(bpy.context, FILE)
assert any("Copy: it was deleted" in m for m in messages) and any("Other: its edits stay" in m for m in messages), messages
# Edits of a material that Blender cannot hold survive, unless Blender's own value changes.
edit(f"{material.name}.specular_tint=0.25 0.5 0.75", f"{material.name}.shadows=none")
transfer.send(bpy.context, FILE, overwrite=True)
kept = FILE.with_name("shot.edited.jen").read_text(encoding="utf-8")
text = FILE.read_text(encoding="utf-8")
assert "specular_tint 0.25 0.5 0.75" in text and "shadows none" in text, text
edit(f"{material.name}.specular_tint=1 1 1")
transfer.send(bpy.context, FILE)
assert "specular_tint" not in FILE.read_text(encoding="utf-8") and "shadows none" in FILE.read_text(encoding="utf-8")
FILE.write_text(FILE.read_text(encoding="utf-8").replace("Copy", "Other"), encoding="utf-8")
transfer.get_lights(bpy.context, FILE)

# Edits of objects are not in the next scene, so the file before is kept, and messages say what it has.
edited = FILE.read_text(encoding="utf-8")
messages = transfer.send(bpy.context, FILE)
assert any(m.startswith("only in shot.edited2.jen now: Copy: it was deleted") for m in messages), messages
assert FILE.with_name("shot.edited2.jen").read_text(encoding="utf-8") == edited
assert FILE.with_name("shot.edited.jen").read_text(encoding="utf-8") == kept, "the scene that was kept before stays"
for name in ("shot.jen", "shot.edited.jen", "shot.edited2.jen"):
    sample.run_program("check", str(FILE.with_name(name)))
assert not any("only in" in m for m in transfer.send(bpy.context, FILE))

# Environments that Blender's world does not show are named.
FILE.write_text(FILE.read_text(encoding="utf-8") + 'dome studio { environment "studio.hdr" }\ndome dark { environment "studio.hdr"  on no }\n', encoding="utf-8")
(FILE.parent / "studio.hdr").write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n" + bytes([128, 128, 128, 129]))
messages = edit("world.sky=yes")
assert "domes, which stay in Lightning: studio" in messages and "world: the physical sky stays in Lightning" in messages, messages
print("all objects are equal")
