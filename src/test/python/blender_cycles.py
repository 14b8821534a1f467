"""Renders lights on matte objects by Cycles and by Lightning, and compares the pictures.

Arguments: a folder, a light, the file of a sky, and whether the "whole" picture is compared or its middle "part", in a quarter of the time.

The bound of each pixel: Cycles' noise is estimated from two pictures with different seeds. Lightning samples each pixel on an 8 x 8 grid,
so at an edge it can count one row of samples too much or too little, an eighth of the contrast of the pixels around.
"""

import math
import sys

import blender_scene as sample
import bpy
import numpy

WIDTH, HEIGHT = 48, 27
SAMPLES = 1024
# Left, right, bottom and top of the compared pixels.
LEFT, RIGHT, BOTTOM, TOP = (0, WIDTH, 0, HEIGHT) if sys.argv[4] == "whole" else (12, 36, 7, 21)
KIND = sys.argv[2]
SKIES = ("sky", "tilted_sky", "tilted_image", "photo")
FILE = sample.FOLDER / "shot.jen"


def build() -> None:
    """Builds a floor, a wall and a ball, all matte, and one light."""
    scene = bpy.context.scene
    for name in ("Cube", "Light"):
        bpy.data.objects.remove(bpy.data.objects[name])
    bpy.ops.mesh.primitive_plane_add(size=8)
    bpy.ops.mesh.primitive_cube_add(size=1, location=(0, 0, 0.5), rotation=(0, 0, 0.4))
    bpy.ops.mesh.primitive_plane_add(size=8, location=(0, 3, 0), rotation=(math.pi / 2, 0, 0))
    material = bpy.data.materials.new("matte")
    shader = material.node_tree.nodes["Principled BSDF"] if material.node_tree else None
    shader.inputs["Base Color"].default_value = (0.8, 0.6, 0.4, 1)
    shader.inputs["Roughness"].default_value = 1
    shader.inputs["Specular IOR Level"].default_value = 0
    for obj in bpy.data.objects:
        if obj.type == "MESH":
            obj.data.materials.append(material)
    scene.camera.location, scene.camera.rotation_euler = (3, -6, 4), (1.05, 0, 0.45)
    scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0
    scene.view_settings.view_transform = "Raw"
    lights = {
        "point": lambda: sample.add_light("POINT", "L", (1, -2, 3), energy=400, color=(1, 0.7, 0.4), shadow_soft_size=0),
        "ball": lambda: sample.add_light("POINT", "L", (1, -2, 3), energy=400, shadow_soft_size=0.4, use_soft_falloff=False),
        "spot": lambda: sample.add_light("SPOT", "L", (1, -2, 4), (0.4, 0.2, 0), energy=900, spot_size=math.radians(50), spot_blend=0.6,
                                         shadow_soft_size=0),
        "sun": lambda: sample.add_light("SUN", "L", rotation=(0.5, 0.4, 0), energy=2, angle=0),
        "wide_sun": lambda: sample.add_light("SUN", "L", rotation=(0.5, 0.4, 0), energy=2, angle=math.radians(60)),
        "rect": lambda: sample.add_light("AREA", "L", (2, -2, 3), (0.6, 0.5, 0), energy=300, shape="RECTANGLE", size=1.5, size_y=0.5),
        "disc": lambda: sample.add_light("AREA", "L", (2, -2, 3), (0.6, 0.5, 0), energy=300, shape="DISK", size=1, exposure=0.5),
        "softbox": lambda: sample.add_light("AREA", "L", (2, -2, 3), (0.6, 0.5, 0), energy=300, shape="RECTANGLE", size=1.5, size_y=0.5,
                                            spread=math.radians(70)),
        "snoot": lambda: sample.add_light("AREA", "L", (1, -2, 4), (0.4, 0.2, 0), energy=100, shape="DISK", size=0.5, spread=math.radians(25)),
        "warm": lambda: sample.add_light("POINT", "L", (1, -2, 3), energy=400, use_temperature=True, temperature=2500,
                                         shadow_soft_size=0),
        "screen": lambda: sample.show_image(sample.add_light("AREA", "L", (1, -1, 1.6), (0.7, 0.5, 0.4), energy=100, shape="RECTANGLE", size=2, size_y=1)),
        "window": lambda: sample.show_image(sample.add_light("AREA", "L", (1, -1, 1.6), (0.7, 0.5, 0.4), energy=100, shape="DISK", size=1.5)),
        "profile": lambda: sample.show_profile(sample.add_light("SPOT", "L", (1, -2, 4), (0.4, 0.2, 0), energy=2, spot_size=math.radians(80), spot_blend=0.3,
                                                  shadow_soft_size=0)),
        "lamp": lambda: sample.show_profile(sample.add_light("POINT", "L", (1, -2, 3), energy=2, shadow_soft_size=0)),
        "profile360": lambda: sample.show_profile(sample.add_light("SPOT", "L", (1, -2, 4), (0.4, 0.2, 0.9), energy=2, spot_size=math.radians(120),
                                                                   spot_blend=0.3, shadow_soft_size=0), range(0, 361, 5)),
        "profile180": lambda: sample.show_profile(sample.add_light("SPOT", "L", (1, -2, 4), (0.4, 0.2, 0.9), energy=2, spot_size=math.radians(120),
                                                                   spot_blend=0, shadow_soft_size=0), range(0, 181, 5)),
        "lamp90": lambda: sample.show_profile(sample.add_light("POINT", "L", (1, -2, 3), (0, 0, 0.6), energy=2, shadow_soft_size=0), range(0, 91, 5)),
        "lamp270": lambda: sample.show_profile(sample.add_light("POINT", "L", (1, -2, 3), energy=2, shadow_soft_size=0), range(90, 271, 5)),
        "lamp360": lambda: sample.show_profile(sample.add_light("POINT", "L", (1, -2, 3), (0, 0, -2), energy=2, shadow_soft_size=0), range(0, 361, 5)),
        "world": lambda: None,
        "sky": lambda: None,
        "tilted_sky": lambda: None,
        "tilted_image": lambda: None,
        "photo": lambda: None,
    }
    light = lights[KIND]()
    if light is None:
        background = scene.world.node_tree.nodes["Background"]
        background.inputs["Color"].default_value = (0.3, 0.5, 0.9, 1)
        background.inputs["Strength"].default_value = 0.7
        scene.world.cycles.sampling_method = "MANUAL"
    else:
        # Cycles has no factor for highlights, and its matte material has none.
        light.data.specular_factor = 0
    if KIND in SKIES:
        show_sky(scene)
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = WIDTH, HEIGHT, 100


def show_sky(scene) -> None:
    """Moves all objects behind the camera: the picture shows a rotated environment image."""
    for obj in bpy.data.objects:
        if obj.type == "MESH":
            obj.location.y -= 60
    scene.camera.rotation_euler = (1.6, 0.1, 0.45)
    tree = scene.world.node_tree
    background = tree.nodes["Background"]
    texture, mapping, coordinates = (tree.nodes.new(f"ShaderNode{n}") for n in ("TexEnvironment", "Mapping", "TexCoord"))
    if KIND != "photo":
        texture.image = bpy.data.images.load(sys.argv[3])
    else:
        # Eight bits of sRGB.
        texture.image = bpy.data.images.new("photo", 64, 32)
        texture.image.pixels.foreach_set([0.5, 0.25, 0.75, 1] * 64 * 32)
    mapping.inputs["Rotation"].default_value = (0.5, -0.4, 0.7) if KIND.startswith("tilted") else (0, 0, 0.7)
    mapping.vector_type = "TEXTURE" if KIND == "tilted_image" else "POINT"
    tree.links.new(coordinates.outputs["Generated"], mapping.inputs["Vector"])
    tree.links.new(mapping.outputs["Vector"], texture.inputs["Vector"])
    tree.links.new(texture.outputs["Color"], background.inputs["Color"])


def cycles(seed: int):
    """Returns Cycles' picture with direct light only."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    settings = scene.cycles
    settings.device, settings.samples, settings.seed = "CPU", SAMPLES, seed
    settings.use_adaptive_sampling = settings.use_denoising = False
    settings.max_bounces = settings.diffuse_bounces = 0
    settings.pixel_filter_type = "BOX"
    settings.filter_width = 1
    scene.render.threads_mode, scene.render.threads = "FIXED", 2
    scene.render.use_border = True
    scene.render.border_min_x, scene.render.border_max_x = LEFT / WIDTH, RIGHT / WIDTH
    scene.render.border_min_y, scene.render.border_max_y = BOTTOM / HEIGHT, TOP / HEIGHT
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.filepath = str(sample.FOLDER / f"cycles{seed}.exr")
    bpy.ops.render.render(write_still=True)
    return pixels(scene.render.filepath)


def pixels(path: str):
    """Returns the linear colors of the compared pixels of an image, from the bottom row."""
    image = bpy.data.images.load(path)
    image.colorspace_settings.name = "Non-Color"
    values = numpy.empty(image.size[0] * image.size[1] * 4, dtype=numpy.float32)
    image.pixels.foreach_get(values)
    return values.reshape(image.size[1], image.size[0], 4)[BOTTOM:TOP, LEFT:RIGHT, :3].astype(numpy.float64)


def contrast(picture):
    """Returns the range of each pixel's neighborhood of 3 x 3."""
    padded = numpy.pad(picture, ((1, 1), (1, 1), (0, 0)), mode="edge")
    shifted = [padded[y:y + picture.shape[0], x:x + picture.shape[1]] for y in range(3) for x in range(3)]
    return numpy.max(shifted, axis=0) - numpy.min(shifted, axis=0)


sample.start()
build()
assert bpy.ops.lightning.send(filepath=str(FILE), overwrite=True) == {"FINISHED"}
sample.run_program("relight", str(FILE), "-o", str(sample.FOLDER / "lightning.exr"), "--set", "picture.antialias=every", "--set",
                   "picture.samples=8", *([] if KIND in ("world", *SKIES) or KIND.startswith(("lamp", "profile")) else ["--set", "L.samples=64"]), "--bits", "32", "--no-savings")
ours = pixels(str(sample.FOLDER / "lightning.exr"))
one, two = cycles(1), cycles(2)
theirs = (one + two) / 2
noise = numpy.abs(one - two) / 2
error = numpy.abs(ours - theirs)
white = theirs.max()
# A thousandth for the steps of both files and of Cycles' own lookup tables.
bound = contrast(theirs) / 8 + 4 * noise.mean() + 0.001 * theirs
if KIND == "world":
    # 48 lights stand for the sky: a point can see two of them too much or too little, at shadows and at its horizon.
    bound += 2 * 4 / 48 * white
if KIND == "photo":
    # Half of a step of Radiance HDR, whose brightest channel is between 1/2 and 1.
    bound += 0.5 / 256
beyond = (error > bound).mean()
ratio = ours.sum() / theirs.sum()
print(f"{KIND}: sum {ratio:.5f}, median error {numpy.median(error / numpy.maximum(theirs, 1e-3 * white)):.5f}, "
      f"noise {noise.mean() / theirs.mean():.5f}, beyond the bound {beyond:.5f}")
# Where 16 or 64 samples of an area light see part of it, they can miss by one sample more.
samples = 1 / 64 if KIND in ("ball", "wide_sun", "rect", "disc", "softbox", "snoot", "screen", "window") else 0
assert not (error > bound + samples * white).any(), KIND
assert abs(ratio - 1) <= (bound + samples * theirs).sum() / theirs.sum(), KIND
