# SPDX-License-Identifier: Apache-2.0
"""The world: one color or an environment texture, as Lightning's environment."""

import math
import shutil
from pathlib import Path

import bpy
import numpy
from mathutils import Matrix

from . import axes

# Lightning looks up the center of an environment along -z, Blender along x.
BASE_ROTATION = -90.0
MAX_PIXELS = 8388608
LEVEL = {"tilt": 0, "roll": 0}
SAMPLING = {"lamps": 48, "softness": 1}


def send(world, folder: Path, stem: str, messages: list[str]) -> dict:
    """Returns the world as Lightning's JSON, and writes its image next to the scene."""
    result = {"ambience": 0}
    background = _background(world)
    if background is None:
        return result
    strength = axes.number(background.inputs["Strength"].default_value)
    texture = _texture(background)
    name = f"{stem}-world.hdr"
    if texture is not None and texture.image is not None:
        _write_image(texture.image, folder / name, messages)
        return result | SAMPLING | {"environment": name, **_rotation(texture, messages), "intensity": strength}
    if background.inputs["Color"].is_linked:
        messages.append("world: only a color or an environment texture is sent")
        return result
    color = [axes.number(max(c, 0)) for c in background.inputs["Color"].default_value[:3]]
    brightest = max(color)
    if brightest * strength > 0:
        # The brightest channel has all of the format's 255 steps.
        pixel = numpy.array([[c / brightest * 255 / 256 for c in color]] * 64 * 32, dtype=numpy.float64)
        (folder / name).write_bytes(radiance(64, 32, pixel))
        result |= SAMPLING | {"environment": name, "intensity": brightest * strength * 256 / 255}
    return result | {"background": [c * strength for c in color]}


def receive(world, settings: dict, before: dict, messages: list[str]) -> None:
    """Changes the world to what Lightning's has become."""
    background = _background(world)
    if background is None or not before:
        return
    if settings.get("environment") != before.get("environment"):
        messages.append("world: the environment was replaced in Lightning and stays there")
        return
    socket = background.inputs["Strength"]
    if settings["intensity"] != before["intensity"] and before["intensity"] > 0:
        socket.default_value *= settings["intensity"] / before["intensity"]
    texture = _texture(background)
    if texture is not None and any(settings.get(angle, 0) != before.get(angle, 0) for angle in ("rotation", "tilt", "roll")):
        to_image = axes.blender_rotation(_to_world(settings) @ Matrix.Rotation(math.radians(-BASE_ROTATION), 3, "Y")).transposed()
        _mapping(world.node_tree, texture).inputs["Rotation"].default_value = to_image.to_euler("XYZ")
    if texture is None and "environment" not in settings and settings["background"] != before["background"]:
        background.inputs["Color"].default_value = settings["background"] + [1]
        socket.default_value = 1


def lost(exported: dict) -> list[str]:
    """Returns messages about environments that Blender's world does not show."""
    domes = [dome["name"] for dome in exported.get("domes", []) if dome["on"] and "environment" in dome]
    messages = [f"domes, which stay in Lightning: {', '.join(domes)}"] if domes else []
    return messages + (["world: the physical sky stays in Lightning"] if exported["world"]["sky"] else [])


def _background(world):
    tree = world.node_tree if world is not None else None
    output = tree.get_output_node("ALL") or tree.get_output_node("CYCLES") if tree else None
    links = output.inputs["Surface"].links if output else ()
    node = links[0].from_node if links else None
    return node if node is not None and node.bl_idname == "ShaderNodeBackground" else None


def _texture(background):
    links = background.inputs["Color"].links
    node = links[0].from_node if links else None
    return node if node is not None and node.bl_idname == "ShaderNodeTexEnvironment" else None


def _rotation(texture, messages: list[str]) -> dict:
    """Returns rotation, tilt and roll of Lightning's environment, degrees."""
    links = texture.inputs["Vector"].links
    node = links[0].from_node if links else None
    if node is None or node.bl_idname != "ShaderNodeMapping":
        return LEVEL | {"rotation": BASE_ROTATION}
    if any(abs(v - 1) > 1e-6 for v in node.inputs["Scale"].default_value):
        messages.append("world: the scale of the mapping is not sent")
    x, y, z = node.inputs["Rotation"].default_value
    if abs(x) <= 1e-6 and abs(y) <= 1e-6:
        return LEVEL | {"rotation": BASE_ROTATION + axes.degrees(z if node.vector_type == "TEXTURE" else -z)}
    rotation = node.inputs["Rotation"].default_value.to_matrix()
    m = axes.lightning_rotation(rotation if node.vector_type == "TEXTURE" else rotation.transposed())
    m = m @ Matrix.Rotation(math.radians(BASE_ROTATION), 3, "Y")
    tilt = math.asin(max(-1, min(1, -m[1][2])))
    if math.hypot(m[0][2], m[2][2]) < 1e-6:
        return {"rotation": axes.degrees(math.atan2(-m[2][0], m[0][0])), "tilt": axes.degrees(tilt), "roll": 0}
    return {"rotation": axes.degrees(math.atan2(m[0][2], m[2][2])), "tilt": axes.degrees(tilt),
            "roll": axes.degrees(math.atan2(m[1][0], m[1][1]))}


def _to_world(settings: dict) -> Matrix:
    """Returns the rotation from the image to the scene in Lightning's axes: roll, then tilt, then rotation."""
    angles = [math.radians(settings.get(angle, 0)) for angle in ("rotation", "tilt", "roll")]
    return Matrix.Rotation(angles[0], 3, "Y") @ Matrix.Rotation(angles[1], 3, "X") @ Matrix.Rotation(angles[2], 3, "Z")


def _mapping(tree, texture):
    """Returns the node that rotates a texture, new if there is none."""
    socket = texture.inputs["Vector"]
    if socket.links and socket.links[0].from_node.bl_idname == "ShaderNodeMapping":
        node = socket.links[0].from_node
        node.vector_type = "POINT"
        return node
    node = tree.nodes.new("ShaderNodeMapping")
    if socket.links:
        tree.links.new(socket.links[0].from_socket, node.inputs["Vector"])
    else:
        tree.links.new(tree.nodes.new("ShaderNodeTexCoord").outputs["Generated"], node.inputs["Vector"])
    tree.links.new(node.outputs["Vector"], socket)
    return node


def _write_image(image, path: Path, messages: list[str]) -> None:
    source = Path(bpy.path.abspath(image.filepath, library=image.library)) if image.filepath else None
    if source is not None and source.suffix.lower() == ".hdr" and source.is_file() and not image.is_dirty:
        if not path.exists() or not source.samefile(path):
            shutil.copyfile(source, path)
        return
    path.write_bytes(radiance(*linear_pixels(image, "world", messages)))


def linear_pixels(image, user: str, messages: list[str]):
    """Returns the width and the height of an image, and its linear colors: a row for each pixel, from the top left. Large ones are reduced."""
    used = image
    width, height = image.size
    if width * height > MAX_PIXELS:
        factor = math.sqrt(MAX_PIXELS / (width * height))
        used = image.copy()
        used.scale(int(width * factor), int(height * factor))
        messages.append(f"{user}: {image.name} was reduced to {used.size[0]} x {used.size[1]} pixels")
    width, height = used.size
    pixels = numpy.empty(width * height * used.channels, dtype=numpy.float32)
    used.pixels.foreach_get(pixels)
    rgb = pixels.reshape(height, width, used.channels)[::-1, :, :3].reshape(-1, 3).astype(numpy.float64)
    # Blender decodes images of floats only.
    if not used.is_float and used.colorspace_settings.name == "sRGB":
        rgb = numpy.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    if used is not image:
        bpy.data.images.remove(used)
    return width, height, rgb


def radiance(width: int, height: int, rgb) -> bytes:
    """Returns a Radiance HDR file without compression; `rgb` has a row for each pixel, from the top left."""
    rgb = numpy.clip(numpy.nan_to_num(rgb), 0, 1e30)
    mantissa, exponent = numpy.frexp(rgb.max(axis=1))
    scale = numpy.where(mantissa > 0, numpy.ldexp(256.0, -exponent), 0)
    encoded = numpy.empty((len(rgb), 4), dtype=numpy.uint8)
    encoded[:, :3] = numpy.minimum(numpy.floor(rgb * scale[:, None] + 0.5), 255)
    encoded[:, 3] = numpy.where(mantissa > 0, exponent + 128, 0)
    return f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n".encode() + encoded.tobytes()
