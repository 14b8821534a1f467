"""Sends a scene next to files of the user, with damaged properties, and while Lightning fails; gets lights of another scene."""

import json
import os

import blender_scene as sample
import bpy

IES = ("IESNA:LM-63-2002\n[TEST] my precious measurement 12345\n[MANUFAC] Acme\nTILT=NONE\n1 1000 1 3 1 1 2 .1 .1 .1\n1 1 50\n0 45 90\n0\n"
       "100 50 0\n")


def folder(name: str):
    """Returns a new folder."""
    result = sample.FOLDER / name
    result.mkdir()
    return result


def contents(path) -> dict:
    """Returns the content of each file."""
    return {file.name: file.read_bytes() for file in path.iterdir() if file.is_file()}


def send(path, **options) -> str:
    """Sends the scene; returns the error."""
    try:
        assert bpy.ops.lightning.send(filepath=str(path), **options) == {"FINISHED"}
        return ""
    except RuntimeError as e:
        return str(e)


def get(path, **options) -> str:
    """Gets lights; returns the error."""
    try:
        assert bpy.ops.lightning.get_lights(filepath=str(path), **options) == {"FINISHED"}
        return ""
    except RuntimeError as e:
        return str(e)


def opens(path) -> None:
    """Fails unless Lightning opens a scene."""
    sample.run_program("check", str(path))


def lights() -> list[str]:
    """Returns the names of the lights."""
    return sorted(obj.name for obj in bpy.context.scene.objects if obj.type == "LIGHT")


# A profile next to the scene belongs to the user.
sample.start()
mine = folder("profile")
(mine / "bulb.ies").write_text(IES, encoding="ascii")
node, tree = sample.emission(sample.add_light("POINT", "Bulb", (0, 0, 3)))
texture = tree.nodes.new("ShaderNodeTexIES")
texture.mode, texture.filepath = "EXTERNAL", str(mine / "bulb.ies")
tree.links.new(texture.outputs["Fac"], node.inputs["Strength"])
for _ in range(2):
    assert not send(mine / "shot.jen")
    assert (mine / "bulb.ies").read_text(encoding="ascii") == IES, "the user's profile"
    assert sorted(contents(mine)) == ["2 bulb.ies", "bulb.ies", "shot-world.hdr", "shot.glb", "shot.jen"], sorted(contents(mine))
    assert '"2 bulb.ies"' in (mine / "shot.jen").read_text(encoding="utf-8")
# A profile whose values change in Blender changes in the scene, too.
before = (mine / "2 bulb.ies").read_bytes()
texture.mode, texture.ies = "INTERNAL", bpy.data.texts.new("bulb")
texture.ies.write(IES.replace("100 50 0", "100 90 0"))
assert not send(mine / "shot.jen")
assert (mine / "2 bulb.ies").read_bytes() != before
assert (mine / "bulb.ies").read_text(encoding="ascii") == IES
assert not get(mine / "shot.jen")
assert not send(mine / "shot.jen")

# A model and a sky without a scene belong to the user.
sample.start()
mine = folder("model")
(mine / "shot.glb").write_bytes(b"my own model")
(mine / "shot-world.hdr").write_bytes(b"my own sky")
assert not send(mine / "shot.jen")
bpy.ops.mesh.primitive_cone_add()
assert not send(mine / "shot.jen")
assert (mine / "shot.glb").read_bytes() == b"my own model"
assert (mine / "shot-world.hdr").read_bytes() == b"my own sky"
assert sorted(contents(mine)) == ["2 shot-world.hdr", "2 shot.glb", "shot-world.hdr", "shot.glb", "shot.jen"], sorted(contents(mine))
opens(mine / "shot.jen")

# If Lightning fails, everything is as before.
sample.start()
mine = folder("failure")
bpy.ops.mesh.primitive_uv_sphere_add(segments=8, ring_count=6)
assert not send(mine / "shot.jen")
before = contents(mine)
bpy.data.objects.remove(bpy.context.object)
bpy.ops.mesh.primitive_cone_add()
program = sample.PROGRAM.read_text(encoding="utf-8")
sample.PROGRAM.write_text("/bin/false\n", encoding="utf-8")
try:
    assert "code 1" in send(mine / "shot.jen")
finally:
    sample.PROGRAM.write_text(program, encoding="utf-8")
assert contents(mine) == before
opens(mine / "shot.jen")

# Lights of a scene that was not sent from here are no edits.
sample.start()
mine = folder("another")
assert not send(mine / "shot.jen")
(mine / "other.jen").write_text("jen 1\nlight Sun directional { direction 0 -1 0 }\nlight Lamp point { at 1 2 3 }\n", encoding="utf-8")
shot = contents(mine)
assert "other.jen was not sent from this scene" in get(mine / "other.jen")
assert lights() == ["Light"]
assert not get(mine / "other.jen", from_another=True)
assert lights() == ["Lamp", "Light", "Sun"], lights()
assert bpy.context.scene.lightning_file == str(mine / "shot.jen")
assert "was not sent from here" in send(mine / "other.jen"), "the lights alone are not the scene"
assert contents(mine) == shot
assert not send(mine / "shot.jen")
assert not get(mine / "shot.jen")
assert lights() == ["Lamp", "Light", "Sun"], lights()

# A copy of the scene is one that was sent.
look = mine / "look.jen"
look.write_bytes((mine / "shot.jen").read_bytes())
sample.set_in_file(look, "Lamp.intensity=2")
assert not get(look)

# Properties of another shape count as none.
SCENE = ('[]', '5', 'null', '"x"', '{"banks":5}', '{"banks":{"a":5}}', '{"banks":{"a":{"color":5}}}', '{"world":[]}', '{"world":{"environment":"/dev/zero"}}',
         '{"picture":5}', '{"picture":{"lightning":{}}}', '{"surfaces":[]}', '{"surfaces":{"values":{},"kept":{"a":{"b":[1]}}}}', '{"lost":5}', '{"digest":[]}',
         '{"views":3}', '{not json', '{"world":{"intensity":1e999}}', '[' * 100000, 5, 1.5, {"banks": 1})
LIGHT = ('[]', '5', '{"settings":5}', '{"settings":{"gobo":"../../../../etc/passwd","type":"point"},"shown":{}}',
         '{"settings":{"type":"point","profile":"/etc/passwd","intensity":"x"},"shown":{"intensity":1}}',
         '{"name":"Light","settings":{"type":"point","intensity":"x","color":5},"shown":{"type":"point"},"group":{"color":[1]},"tracks":{}}',
         '{"name":"Light","settings":{"type":"point","intensity":"x","color":5},"shown":{"type":"point"},"group":{},"tracks":{}}', 7, {"a": 1})
mine = folder("properties")
sample.start()
from bl_ext.user_default.lightning import memory, transfer  # noqa: E402, after the add-on is enabled

scene, light = bpy.context.scene, bpy.data.objects["Light"]
for block, values in ((scene, SCENE), (light, LIGHT)):
    for value in values:
        block["lightning"] = value
        assert block is light or not memory.of_scene(scene), value
        messages = memory.damage([scene, light])
        assert bool(messages) == (block is scene or not memory.of_light(light)), (value, messages)
        transfer.prepare(bpy.context, mine / "prepared.jen", [])
        if not messages or value == SCENE[0]:
            assert not send(mine / "shot.jen", overwrite=True), value
            assert not get(mine / "shot.jen"), value
    del scene["lightning"], light["lightning"]

print("no file of the user has changed")
