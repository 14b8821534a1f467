"""Sends skies, fog and settings that Lightning lacks, edits the sky in Lightning, and gets it back."""

import math

import blender_scene as sample
import bpy

FILE = sample.FOLDER / "shot.jen"


def sent() -> tuple[str, list[str]]:
    """Sends the scene. Returns its file and the messages."""
    messages = transfer.send(bpy.context, FILE, overwrite=True)
    return FILE.read_text(encoding="utf-8"), messages


def volume(block, kind: str, **values):
    """Gives a world or a material a volume, and nothing else."""
    block.use_nodes = True
    tree = block.node_tree
    node = tree.nodes.new(kind)
    for key, value in values.items():
        node.inputs[key.replace("_", " ")].default_value = value
    output = tree.get_output_node("ALL")
    tree.links.new(node.outputs[0], output.inputs["Volume"])
    return node


def box(name: str, location, scale, rotation=(0, 0, 0), **values):
    """Adds a box with nothing but a volume."""
    bpy.ops.mesh.primitive_cube_add(size=1, location=location, rotation=rotation)
    obj = bpy.context.object
    obj.name, obj.scale = name, scale
    material = bpy.data.materials.new(name)
    volume(material, "ShaderNodeVolumePrincipled", **values)
    tree = material.node_tree
    for link in [link for link in tree.links if link.to_socket.name == "Surface"]:
        tree.links.remove(link)
    obj.data.materials.append(material)
    return obj


def assert_has(text: str, *parts: str) -> None:
    for part in parts:
        assert part in " ".join(text.split()), (part, text)


sample.start()
from bl_ext.user_default.lightning import transfer  # noqa: E402, after the add-on is enabled

scene = bpy.context.scene
scene.render.engine = "CYCLES"
scene.world.use_nodes = True
tree = scene.world.node_tree
_, messages = sent()
assert not [line for line in messages if "not sent" in line], messages

# A sky is Lightning's physical sky.
sky = tree.nodes.new("ShaderNodeTexSky")
background = tree.nodes["Background"]
tree.links.new(sky.outputs["Color"], background.inputs["Color"])
background.inputs["Strength"].default_value = 0.1
sky.sun_elevation, sky.sun_rotation, sky.sun_intensity = math.radians(30), math.radians(60), 0.5
text, messages = sent()
assert_has(text, "sky yes", "sky_elevation 30", "sky_azimuth 60", "sky_sun 0.5", "intensity 1.31")
assert not [line for line in messages if "world" in line], messages
sample.set_in_file(FILE, "world.sky_elevation=45", "world.sky_azimuth=90")
messages = transfer.get_lights(bpy.context, FILE)
assert not [line for line in messages if "sky" in line], messages
assert (round(math.degrees(sky.sun_elevation), 3), round(math.degrees(sky.sun_rotation), 3)) == (45, 90)
sky.sun_disc = False
assert_has(sent()[0], "sky_sun 0 ")
tree.links.remove(background.inputs["Color"].links[0])
assert "sky yes" not in sent()[0]

# Fog of the world.
scatter = volume(scene.world, "ShaderNodeVolumeScatter", Color=(0.5, 0.5, 0.5, 1), Density=0.2, Anisotropy=0.25)
text, messages = sent()
assert_has(text, "fog 0.1 ", "fog_anisotropy 0.25")
assert not [line for line in messages if "world" in line], messages
noise = tree.nodes.new("ShaderNodeTexNoise")
tree.links.new(noise.outputs[0], scatter.inputs["Density"])
text, messages = sent()
assert "fog 0.1" not in text and "only a volume with the same content everywhere" in "\n".join(messages), messages
tree.nodes.remove(scatter)

# Fog of a box, and boxes that are left out.
smoke = box("Smoke", (1, 2, 3), (4, 5, 6), Color=(0.25, 0.5, 1, 1), Density=0.3)
text, messages = sent()
assert_has(text, "fog 0.3 ", "fog_color 0.25 0.5 1", "fog_center 1 3 -2", "fog_size 4 6 5")
assert "Smoke" not in text and not [line for line in messages if "Smoke" in line], messages
box("Steam", (9, 0, 0), (1, 1, 1))
box("Turned", (-9, 0, 0), (1, 1, 1), (0, 0.5, 0))
text, messages = sent()
assert "Steam" not in text and "Turned" not in text
assert "only one fog is sent, so these volumes are left out: Steam" in messages, messages
assert "volumes of shapes other than a box along the axes are not sent: Turned" in messages, messages
for name in ("Smoke", "Steam", "Turned"):
    bpy.data.objects.remove(bpy.data.objects[name])
assert "fog" not in sent()[0]

# What Lightning lacks has a message each.
window = sample.add_light("AREA", "Window")
window.data.cycles.is_portal = True
sample.add_light("POINT", "Short").data.cycles.max_bounces = 3
scene.view_settings.look = "AgX - Punchy"
scene.view_settings.gamma = 1.2
scene.view_settings.use_curve_mapping = scene.view_settings.use_white_balance = True
scene.render.film_transparent = scene.render.use_motion_blur = True
dof = scene.camera.data.dof
dof.use_dof, dof.aperture_fstop, dof.focus_distance, dof.aperture_ratio = True, 1.25, 7, 1.5
dof.aperture_blades, dof.aperture_rotation = 6, math.radians(70)
scene.camera.data.lens = 50
text, messages = sent()
assert "light Window" not in text and "light Short" in text
for part in ("look AgX - Punchy", "gamma", "curves of the view", "white balance", "transparent film", "motion blur", "ratio of the camera's aperture",
             "Window: a portal is not sent", "Short: its largest number of bounces (3)"):
    assert len([line for line in messages if part in line]) == 1, (part, messages)

# A lens of 50 mm and f/1.25 is open by 2 cm. The plane of focus through an object is perpendicular to the view.
assert "aperture 0.02 " in " ".join(text.split()) and "focus 7 " in " ".join(text.split()), text
assert "blades 6 " in " ".join(text.split()) and "blade_rotation 10" in text, text
matrix = scene.camera.matrix_world
target = bpy.data.objects.new("Target", None)
scene.collection.objects.link(target)
target.location = matrix.translation - 3 * matrix.col[2].to_3d() + 2 * matrix.col[0].to_3d()
dof.focus_object = target
bpy.context.view_layer.update()
assert "focus 3 " in " ".join(sent()[0].split()), sent()[0]
dof.use_dof = False
assert "aperture" not in sent()[0]
print("the world is equal")
