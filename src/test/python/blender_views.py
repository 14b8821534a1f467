"""Prints what Blender shows for random linear pixels.

Arguments: the number of pixels, and the seed. A line has red, green and blue of a pixel, and the codes, 0 to 255, of each view.
"""

import random
import sys
import tempfile
from pathlib import Path

import bpy

VIEWS = ["AgX", "Filmic"]


def codes(pixels: list[list[float]], view: str) -> list[list[int]]:
    """Returns the codes of pixels in a view."""
    scene = bpy.context.scene
    scene.display_settings.display_device = "sRGB"
    scene.view_settings.view_transform = view
    scene.view_settings.look = "None"
    scene.render.dither_intensity = 0
    scene.render.image_settings.file_format = "PNG"
    scene.render.image_settings.color_depth = "8"
    scene.render.image_settings.color_mode = "RGB"
    image = bpy.data.images.new(view, len(pixels), 1, float_buffer=True)
    image.colorspace_settings.name = "Linear Rec.709"
    image.pixels = [value for pixel in pixels for value in [*pixel, 1]]
    with tempfile.TemporaryDirectory() as folder:
        file = str(Path(folder, "shown.png"))
        image.save_render(file, scene=scene)
        shown = bpy.data.images.load(file)
        shown.colorspace_settings.name = "Non-Color"
        values = [round(value * 255) for value in shown.pixels]
    return [values[4 * i : 4 * i + 3] for i in range(len(pixels))]


def pixel(at: random.Random) -> list[float]:
    """Returns a pixel: a gray, a color, a saturated one, one outside of Rec. 709, or channels that have nothing to do with each other."""
    value = 2 ** at.uniform(-12, 9)
    kind = at.randrange(5)
    if kind == 0:
        return [value] * 3
    if kind == 4:
        return [2 ** at.uniform(-12, 9) for _ in range(3)]
    lowest = {1: 0.2, 2: 0, 3: -0.3}[kind]
    return [value * at.choice([1, lowest, at.uniform(lowest, 1)]) for _ in range(3)]


at = random.Random(int(sys.argv[2]))
pixels = [[float(f"{value:.6g}") for value in pixel(at)] for _ in range(int(sys.argv[1]))]
shown = [codes(pixels, view) for view in VIEWS]
for i, values in enumerate(pixels):
    print(*[f"{value:g}" for value in values], *[code for view in shown for code in view[i]])
