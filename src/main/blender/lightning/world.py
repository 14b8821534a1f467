# SPDX-License-Identifier: Apache-2.0
"""The world: one color or an environment texture, as Lightning's environment."""

import math
import shutil
from pathlib import Path

import bpy
import numpy
from mathutils import Matrix, Vector

from . import axes, volumes

# Lightning looks up the center of an environment along -z, Blender along x.
BASE_ROTATION = -90.0
MAX_PIXELS = 8388608
LEVEL = {"tilt": 0, "roll": 0}
SAMPLING = {"lamps": 48, "softness": 1}
# Blender's skies, their brightness relative to Lightning's for strength 1, and whether they have a sun. With one, both light the ground
# equally within 5 percent from 15 degrees on.
SKIES = {"MULTIPLE_SCATTERING": (13.1, True), "SINGLE_SCATTERING": (12.4, True), "PREETHAM": (1, False), "HOSEK_WILKIE": (0.14, False)}
# Turbidity that an aerosol density of 1 adds to that of pure air.
TURBIDITY_PER_AEROSOL = 0.25
# World without a sky or a fog.
OFF = {"sky": {"sky": False}, "fog": {"fog": 0, "fog_color": [1, 1, 1], "fog_anisotropy": 0, "fog_center": [0, 0, 0], "fog_size": [0, 0, 0]}}
SUN_RADII = (0.05, 20)


def send(world, folder: Path, stem: str, messages: list[str]) -> dict:
    """Returns the world as Lightning's JSON, and writes its image next to the scene."""
    result = {"ambience": 0} | (volumes.fog(world, "world", messages) if world is not None else {})
    background = _background(world)
    if background is None:
        return result
    strength = axes.number(background.inputs["Strength"].default_value)
    texture = _texture(background)
    name = f"{stem}-world.hdr"
    if texture is not None and texture.image is not None:
        _write_image(texture.image, folder / name, messages)
        return result | SAMPLING | {"environment": name, **_rotation(texture, messages), "intensity": strength}
    sky = _sky(background)
    if sky is not None:
        return result | {"background": [0, 0, 0], "rotation": 0, **LEVEL, **_sky_settings(sky, strength, messages)}
    if background.inputs["Color"].is_linked:
        messages.append("world: only a color, an environment texture or a sky texture is sent")
        return result
    color = [axes.number(max(c, 0)) for c in background.inputs["Color"].default_value[:3]]
    brightest = max(color)
    if brightest * strength > 0:
        # The brightest channel has all of the format's 255 steps.
        pixel = numpy.array([[c / brightest * 255 / 256 for c in color]] * 64 * 32, dtype=numpy.float64)
        (folder / name).write_bytes(radiance(64, 32, pixel))
        result |= SAMPLING | {"environment": name, "intensity": brightest * strength * 256 / 255}
    return result | {"background": [c * strength for c in color]}


def _sky_settings(sky, strength: float, messages: list[str]) -> dict:
    """Returns a sky texture as Lightning's physical sky."""
    gain, has_sun = SKIES[sky.sky_type]
    if sky.inputs and sky.inputs[0].is_linked:
        messages.append("world: the mapping of the sky texture is not sent")
    if sky.sky_type != "MULTIPLE_SCATTERING":
        messages.append("world: the sky texture became a physical sky of about the same brightness, but another model")
    if not has_sun:
        direction = Vector(sky.sun_direction).normalized()
        return {"sky": True, "intensity": strength * gain, "sky_elevation": max(axes.degrees(math.asin(direction.z)), -18),
                "sky_azimuth": axes.degrees(math.atan2(direction.x, direction.y)), "sky_turbidity": max(1, min(axes.number(sky.turbidity), 10)),
                "sky_ground": [0, 0, 0], "sky_sun": 0, "sky_unit": "relative"}
    if any(abs(value - 1) > 1e-6 for value in (sky.air_density, sky.ozone_density)):
        messages.append("world: the densities of air and ozone of the sky texture are not sent")
    return {"sky": True, "intensity": strength * gain, "sky_elevation": max(axes.degrees(sky.sun_elevation), -18),
            "sky_azimuth": axes.degrees(sky.sun_rotation), "sky_turbidity": min(1 + TURBIDITY_PER_AEROSOL * axes.number(sky.aerosol_density), 10),
            "sky_ground": [0, 0, 0], "sky_sun": axes.number(sky.sun_intensity) if sky.sun_disc else 0,
            "sky_sun_radius": max(SUN_RADII[0], min(axes.degrees(sky.sun_size / 2), SUN_RADII[1])), "sky_unit": "relative"}


def kinds(world) -> list[str]:
    """Returns which of the attributes that switch parts of Lightning's world on are from Blender."""
    background = _background(world)
    return [key for key, is_there in (("sky", background is not None and _sky(background) is not None),
                                      ("fog", world is not None and bool(volumes.fog(world, "world", [])))) if is_there]


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
    _receive_sky(_sky(background), settings, before)
    texture = _texture(background)
    if texture is not None and any(settings.get(angle, 0) != before.get(angle, 0) for angle in ("rotation", "tilt", "roll")):
        to_image = axes.blender_rotation(_to_world(settings) @ Matrix.Rotation(math.radians(-BASE_ROTATION), 3, "Y")).transposed()
        _mapping(world.node_tree, texture).inputs["Rotation"].default_value = to_image.to_euler("XYZ")
    if texture is None and not background.inputs["Color"].is_linked and "environment" not in settings and settings["background"] != before["background"]:
        background.inputs["Color"].default_value = settings["background"] + [1]
        socket.default_value = 1


def _receive_sky(sky, settings: dict, before: dict) -> None:
    if sky is None:
        return
    has_sun = SKIES[sky.sky_type][1]

    def changed(key: str) -> bool:
        return settings[key] != before.get(key, settings[key])

    if has_sun and changed("sky_elevation"):
        sky.sun_elevation = math.radians(settings["sky_elevation"])
    if has_sun and changed("sky_azimuth"):
        sky.sun_rotation = math.radians(settings["sky_azimuth"])
    if has_sun and changed("sky_sun"):
        sky.sun_disc, sky.sun_intensity = settings["sky_sun"] > 0, settings["sky_sun"]
    if has_sun and changed("sky_sun_radius"):
        sky.sun_size = math.radians(2 * settings["sky_sun_radius"])
    if has_sun and changed("sky_turbidity"):
        sky.aerosol_density = (settings["sky_turbidity"] - 1) / TURBIDITY_PER_AEROSOL


def lost(world, exported: dict) -> list[str]:
    """Returns messages about environments that Blender's world does not show."""
    domes = [dome["name"] for dome in exported.get("domes", []) if dome["on"] and "environment" in dome]
    messages = [f"domes, which stay in Lightning: {', '.join(domes)}"] if domes else []
    return messages + (["world: the physical sky stays in Lightning"] if exported["world"]["sky"] and "sky" not in kinds(world) else [])


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


def _sky(background):
    links = background.inputs["Color"].links
    node = links[0].from_node if links else None
    return node if node is not None and node.bl_idname == "ShaderNodeTexSky" else None


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
