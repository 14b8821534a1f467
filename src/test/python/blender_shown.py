"""Makes a small scene by its name, sends it to Lightning, and writes the messages."""

import math
import sys

import blender_scene as sample
import bpy
import numpy


def add(name: str, data, location=(0, 0, 0), collection=None):
    """Adds an object."""
    obj = bpy.data.objects.new(name, data)
    obj.location = location
    (collection or bpy.context.scene.collection).objects.link(obj)
    return obj


def cube(name: str, location=(0, 0, 0), collection=None):
    """Adds a cube with sides of 0.8."""
    mesh = bpy.data.meshes.new(name)
    corners = [(x, y, z) for x in (-0.4, 0.4) for y in (-0.4, 0.4) for z in (-0.4, 0.4)]
    mesh.from_pydata(corners, [], [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)])
    return add(name, mesh, location, collection)


def instance(name: str, collection, location=(0, 0, 0), into=None):
    """Adds an instance of a collection."""
    obj = add(name, None, location, into)
    obj.instance_type, obj.instance_collection = "COLLECTION", collection
    return obj


def nodes(obj, make) -> None:
    """Adds geometry nodes; `make` returns the socket of the result from the tree and the socket of the object's geometry."""
    tree = bpy.data.node_groups.new("nodes", "GeometryNodeTree")
    for in_out in ("INPUT", "OUTPUT"):
        tree.interface.new_socket("Geometry", in_out=in_out, socket_type="NodeSocketGeometry")
    start, end = tree.nodes.new("NodeGroupInput"), tree.nodes.new("NodeGroupOutput")
    tree.links.new(make(tree, start.outputs[0]), end.inputs[0])
    obj.modifiers.new("nodes", "NODES").node_group = tree


def balls(tree, points):
    """Returns icospheres of radius 0.2 at points."""
    put, ball = tree.nodes.new("GeometryNodeInstanceOnPoints"), tree.nodes.new("GeometryNodeMeshIcoSphere")
    ball.inputs["Radius"].default_value = 0.2
    tree.links.new(points, put.inputs["Points"])
    tree.links.new(ball.outputs["Mesh"], put.inputs["Instance"])
    return put.outputs[0]


def both(tree, geometry):
    """Returns a geometry with instances of it, of which half are a mesh."""
    join, realize = tree.nodes.new("GeometryNodeJoinGeometry"), tree.nodes.new("GeometryNodeRealizeInstances")
    move = tree.nodes.new("GeometryNodeTransform")
    move.inputs["Translation"].default_value = (0, 0, 4)
    tree.links.new(balls(tree, geometry), realize.inputs[0])
    tree.links.new(realize.outputs[0], move.inputs["Geometry"])
    for socket in (balls(tree, geometry), move.outputs[0]):
        tree.links.new(socket, join.inputs[0])
    return join.outputs[0]


def keyed(obj, path: str, first, last) -> None:
    """Adds keys at the frames 1 and 12."""
    scene.frame_start, scene.frame_end = 1, 12
    for frame, value in ((1, first), (12, last)):
        setattr(obj, path, value)
        obj.keyframe_insert(path, frame=frame)
    scene.frame_set(1)


def hidden() -> None:
    parent = add("parent", None, (0, 0, 3))
    for name, x in (("screen", 2), ("eye", 4), ("collection", 6), ("shown", 8)):
        cube(name, (x, 0, 0)).parent = parent
    hiding = bpy.data.collections.new("hiding")
    scene.collection.children.link(hiding)
    hiding.objects.link(bpy.data.objects["collection"])
    scene.collection.objects.unlink(bpy.data.objects["collection"])
    lamp = sample.add_light("AREA", "lamp", (1, 2, 3), size=2)
    lamp.scale = (3, 3, 3)
    keyed(bpy.data.objects["screen"], "location", (2, 0, 0), (2, 0, 5))
    lamp.hide_viewport = parent.hide_viewport = bpy.data.objects["screen"].hide_viewport = hiding.hide_viewport = True
    bpy.data.objects["eye"].hide_set(True)
    # After a file is loaded, Blender has not computed where hidden objects are.
    bpy.ops.wm.save_as_mainfile(filepath=str(sample.FOLDER / "hidden.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(sample.FOLDER / "hidden.blend"))


def sheared() -> None:
    parent = add("parent", None, (4, 0, 0))
    parent.scale = (1, 1, 0.3)
    child = cube("sheared")
    child.parent, child.rotation_euler = parent, (0, 0.8, 0)


def tall_key(obj):
    """Adds a shape key that makes an object 2.5 times as tall."""
    obj.shape_key_add(name="Basis")
    key = obj.shape_key_add(name="tall")
    for corner in key.data:
        corner.co.z *= 2.5
    return key


def keys() -> None:
    tall_key(cube("shape")).value = 1


def levels() -> None:
    modifier = cube("smooth").modifiers.new("subdivision", "SUBSURF")
    modifier.levels, modifier.render_levels = 0, 3


def instances() -> None:
    nodes(cube("scatter", (5, 0, 0)), balls)
    nodes(cube("joined"), both)
    keyed(bpy.data.objects["scatter"], "location", (5, 0, 0), (5, 0, 7))


def metaball() -> None:
    data = bpy.data.metaballs.new("meta")
    data.render_resolution = 0.05
    data.elements.new().radius = 1
    add("meta", data, (0, 0, 2))


def hair() -> None:
    curves = bpy.data.hair_curves.new("curves")
    curves.add_curves([2, 3])
    curves.points.foreach_set("position", (0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 1, 1, 0, 2))
    curves.attributes.new("radius", "FLOAT", "POINT").data.foreach_set("value", [0.01] * 5)
    add("strands", curves)
    field = add("field", bpy.data.meshes.new("field"), (9, 0, 0))
    field.data.from_pydata([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], [], [(0, 1, 2, 3)])
    field.rotation_euler = (math.pi / 2, 0, 0)
    field.modifiers.new("hair", "PARTICLE_SYSTEM")
    settings = field.particle_systems[0].settings
    settings.type, settings.count, settings.hair_length, settings.render_step = "HAIR", 100, 0.5, 3


def too_much_hair() -> None:
    strands = bpy.data.hair_curves.new("strands")
    strands.add_curves([2] * 150_000)
    points = numpy.zeros((150_000, 2, 3), dtype=numpy.float32)
    points[:, 1, 2] = 1
    strands.points.foreach_set("position", points.reshape(-1))
    add("coat", strands)


def camera() -> None:
    cube("seen")
    cube("unseen", (3, 0, 0)).visible_camera = False
    cube("indirect", (6, 0, 0)).visible_shadow = False
    cube("catcher", (9, 0, 0)).is_shadow_catcher = True
    bounce = bpy.data.collections.new("bounce")
    scene.collection.children.link(bounce)
    cube("bounced", (12, 0, 0), bounce)
    bpy.context.view_layer.layer_collection.children["bounce"].indirect_only = True


def lamps() -> None:
    inner, outer = bpy.data.collections.new("inner"), bpy.data.collections.new("outer")
    bulb = add("bulb", bpy.data.lights.new("bulb", "POINT"), (0, 0, 1.5), inner)
    bulb.data.energy = 100
    cube("shade", (0, 0, 2), inner)
    off = cube("off", (0, 0, 9), inner)
    off.hide_render = True
    instance("nested", inner, (0, 5, 0), outer)
    instance("first", inner, (-2, 0, 0))
    instance("second", outer, (2, 0, 0)).scale = (2, 2, 2)


def types() -> None:
    curve = bpy.data.curves.new("pipe", "CURVE")
    curve.dimensions, curve.bevel_depth = "3D", 0.1
    spline = curve.splines.new("POLY")
    spline.points.add(1)
    spline.points[0].co, spline.points[1].co = (-1, 0, 0, 1), (1, 0, 0, 1)
    add("pipe", curve)
    text = bpy.data.curves.new("text", "FONT")
    text.body = "I"
    add("text", text, (0, 0, 5))
    add("wire", bpy.data.curves.new("wire", "CURVE"), (0, 0, 9))
    add("fog", bpy.data.volumes.new("fog"))
    for name in ("dust", "snow"):
        add(name, bpy.data.pointclouds.new(name))
    add("sketch", bpy.data.grease_pencils.new("sketch"))


def shaders() -> None:
    def material(name: str, build) -> None:
        result = bpy.data.materials.new(name)
        tree = result.node_tree
        tree.nodes.remove(tree.nodes["Principled BSDF"])
        tree.links.new(build(tree).outputs[0], tree.nodes["Material Output"].inputs["Surface"])
        cube(name, (len(bpy.data.materials), 0, 0)).data.materials.append(result)

    def node(tree, kind: str, **values):
        made = tree.nodes.new("ShaderNode" + kind)
        for name, value in values.items():
            made.inputs[name].default_value = value
        return made

    def joined(tree, kind: str, first, second, factor=None):
        made = tree.nodes.new("ShaderNode" + kind)
        shown = [socket for socket in made.inputs if socket.type == "SHADER"]
        for socket, shader in zip(shown, (first, second)):
            tree.links.new(shader.outputs[0], socket)
        if isinstance(factor, float):
            made.inputs[0].default_value = factor
        elif factor is not None:
            tree.links.new(factor.outputs[0], made.inputs[0])
        return made

    def diffuse(tree):
        return node(tree, "BsdfDiffuse", Color=(0.5, 0.25, 0.125, 1))

    def glossy(tree):
        return node(tree, "BsdfAnisotropic", Color=(0.5, 0.25, 0.125, 1), Roughness=0.25)

    def grouped(tree):
        group = bpy.data.node_groups.new("paint", "ShaderNodeTree")
        group.interface.new_socket("Tone", in_out="INPUT", socket_type="NodeSocketColor")
        group.interface.new_socket("Out", in_out="OUTPUT", socket_type="NodeSocketShader")
        start, end, inner = group.nodes.new("NodeGroupInput"), group.nodes.new("NodeGroupOutput"), group.nodes.new("ShaderNodeBsdfDiffuse")
        group.links.new(start.outputs[0], inner.inputs["Color"])
        group.links.new(inner.outputs[0], end.inputs[0])
        made = tree.nodes.new("ShaderNodeGroup")
        made.node_tree = group
        made.inputs[0].default_value = (0.25, 0.5, 0.75, 1)
        return made

    def image(tree):
        picture = bpy.data.images.new("wood", 4, 4)
        picture.pixels = [((i * 7) % 11) / 11 for i in range(64)]
        picture.pack()
        made = tree.nodes.new("ShaderNodeTexImage")
        made.image = picture
        shader = diffuse(tree)
        tree.links.new(made.outputs["Color"], shader.inputs["Color"])
        return shader

    material("paint", diffuse)
    material("metal", glossy)
    material("crystal", lambda tree: node(tree, "BsdfGlass"))
    material("glow", lambda tree: node(tree, "Emission", Color=(1, 0.5, 0.25, 1), Strength=3))
    material("plastic", lambda tree: joined(tree, "MixShader", diffuse(tree), node(tree, "BsdfAnisotropic", Color=(1, 1, 1, 1), Roughness=0.25),
                                            node(tree, "Fresnel", IOR=3)))
    material("mixed", lambda tree: joined(tree, "MixShader", diffuse(tree), glossy(tree), 0.25))
    material("lamp", lambda tree: joined(tree, "AddShader", diffuse(tree), node(tree, "Emission", Color=(1, 1, 1, 1), Strength=2)))
    material("veil", lambda tree: joined(tree, "MixShader", node(tree, "BsdfTransparent"), diffuse(tree), 0.75))
    material("lacquer", lambda tree: joined(tree, "MixShader", glossy(tree), node(tree, "BsdfAnisotropic", Color=(1, 1, 1, 1), Roughness=0.125),
                                            node(tree, "Fresnel", IOR=1.75)))
    material("boxed", grouped)
    material("wood", image)
    material("leaf", lambda tree: node(tree, "BsdfTranslucent", Color=(0.25, 0.5, 0.125, 1)))
    material("velvet", lambda tree: joined(tree, "AddShader", diffuse(tree), node(tree, "BsdfSheen", Color=(1, 0.5, 0.25, 1), Roughness=0.375)))
    material("brush", lambda tree: node(tree, "BsdfAnisotropic", Anisotropy=0.5))
    cube("plain", (-3, 0, 0)).data.materials.append(bpy.data.materials.new("plain"))
    silk = bpy.data.materials.new("silk")
    for name, value in (("Sheen Weight", 0.5), ("Sheen Tint", (1, 0.5, 0.25, 1)), ("Sheen Roughness", 0.25)):
        silk.node_tree.nodes["Principled BSDF"].inputs[name].default_value = value
    steel = bpy.data.materials.new("steel")
    for name, value in (("Anisotropic", 0.5), ("Anisotropic Rotation", 0.125)):
        steel.node_tree.nodes["Principled BSDF"].inputs[name].default_value = value
    cube("steel", (-15, 0, 0)).data.materials.append(steel)
    cube("silk", (-12, 0, 0)).data.materials.append(silk)
    skin = bpy.data.materials.new("skin")
    skin.node_tree.nodes["Principled BSDF"].inputs["Subsurface Weight"].default_value = 0.5
    skin.node_tree.nodes["Principled BSDF"].inputs["Specular IOR Level"].default_value = 0.25
    cube("skin", (-6, 0, 0)).data.materials.append(skin)
    rough = bpy.data.materials.new("rough")
    rough.node_tree.links.new(rough.node_tree.nodes.new("ShaderNodeDisplacement").outputs[0], rough.node_tree.nodes["Material Output"].inputs["Displacement"])
    cube("rough", (-9, 0, 0)).data.materials.append(rough)


def linked() -> None:
    def material(name: str, **links):
        result = bpy.data.materials.new(name)
        tree = result.node_tree
        shader = tree.nodes["Principled BSDF"]
        shader.inputs["Coat Weight"].default_value = 0.5
        for socket, (kind, value) in links.items():
            node = tree.nodes.new("ShaderNode" + kind)
            if value is not None:
                node.outputs[0].default_value = value
            tree.links.new(node.outputs[0], shader.inputs[socket.replace("_", " ")])
        cube(name, (len(bpy.data.materials), 0, 0)).data.materials.append(result)
        return shader

    material("constant", Base_Color=("RGB", (0.25, 0.5, 0.75, 1)), IOR=("Value", 2.0), Coat_Weight=("Value", 0.25), Coat_IOR=("Value", 1.75))
    material("lacquer")
    material("noisy", Base_Color=("TexNoise", None), Coat_Roughness=("TexNoise", None))
    material("bumpy", Normal=("Bump", None), Coat_Normal=("Bump", None))
    material("colored").inputs["Coat Tint"].default_value = (1, 0.5, 0.25, 1)


def motion() -> None:
    inner = bpy.data.collections.new("inner")
    keyed(cube("wheel", (0, 0, 0), inner), "location", (0, 0, 0), (0, 0, 5))
    instance("car", inner, (3, 0, 0))
    keyed(cube("ghost", (6, 0, 0)), "hide_render", False, True)
    keyed(tall_key(cube("growing", (9, 0, 0))), "value", 0.0, 1.0)


def untouched() -> None:
    hidden_one = cube("hidden")
    hidden_one.hide_viewport = True
    modifier = cube("edited", (2, 0, 0)).modifiers.new("subdivision", "SUBSURF")
    modifier.levels, modifier.render_levels = 0, 2
    instances()
    bpy.context.view_layer.objects.active = bpy.data.objects["edited"]
    bpy.ops.object.mode_set(mode="EDIT")


def state() -> list:
    """Returns what a user sees of the file."""
    layer, window = bpy.context.view_layer, bpy.context.window
    return [window.scene.name, window.view_layer.name, layer.objects.active.name, layer.objects.active.mode, scene.render.engine, scene.frame_current,
            [(obj.name, obj.hide_viewport, obj.hide_render, obj.hide_get(), obj.select_get(), [tuple(row) for row in obj.matrix_world])
             for obj in scene.objects],
            [sorted(block.name for block in getattr(bpy.data, kind)) for kind in ("scenes", "objects", "meshes", "materials", "cameras", "images")]]


def get_back() -> None:
    """Edits lights of instances in Lightning: Blender gets none of them, and messages name the edited ones."""
    target = sample.FOLDER / "scene.jen"
    assert not [m for m in transfer.get_lights(bpy.context, target) if "bulb" in m]
    assert [obj.name for obj in scene.objects if obj.type == "LIGHT"] == ["Light"]
    sample.set_in_file(target, "bulb of first.intensity=3")
    received = transfer.get_lights(bpy.context, target)
    assert [obj.name for obj in scene.objects if obj.type == "LIGHT"] == ["Light"], received
    assert [m for m in received if "bulb of first" in m and "second" not in m], received
    assert any("only in scene.edited.jen now: bulb of first" in m for m in transfer.send(bpy.context, target))
    assert not any("bulb" in m for m in transfer.get_lights(bpy.context, target))


def move_back() -> None:
    """Moves an object with instances in Lightning: it moves in Blender."""
    target = sample.FOLDER / "scene.jen"
    bpy.data.objects["joined"].rotation_euler = (0, 0, 0.5)
    transfer.send(bpy.context, target)
    sample.set_in_file(target, "joined.at=1 2 3")
    assert not transfer.get_lights(bpy.context, target)
    joined = bpy.data.objects["joined"]
    assert all(abs(a - b) < 1e-5 for a, b in zip((*joined.location, joined.rotation_euler.z), (1, -3, 2, 0.5))), joined.matrix_world


sample.start()
scene = bpy.context.scene
bpy.data.objects.remove(bpy.data.objects["Cube"])
case = sys.argv[2]
{"hidden": hidden, "sheared": sheared, "keys": keys, "levels": levels, "instances": instances, "metaball": metaball, "hair": hair,
 "too_much_hair": too_much_hair, "camera": camera, "lamps": lamps, "types": types, "shaders": shaders, "linked": linked, "motion": motion,
 "untouched": untouched}[case]()
scene = bpy.context.scene
from bl_ext.user_default.lightning import transfer  # noqa: E402, after the add-on is enabled

bpy.context.view_layer.update()
before = state() if case == "untouched" else None
messages = transfer.send(bpy.context, sample.FOLDER / "scene.jen")
assert before is None or before == state(), (before, state())
(sample.FOLDER / "messages.txt").write_text("\n".join(messages), encoding="utf-8")
if case == "lamps":
    get_back()
if case == "instances":
    move_back()
print("sent")
