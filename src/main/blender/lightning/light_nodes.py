# SPDX-License-Identifier: Apache-2.0
"""Node trees of lights: one Emission, whose color can be an image and whose strength an IES profile."""

import math
import re
from pathlib import Path

import bpy
from mathutils import Vector

from . import ies, spot_edge, world

# Cycles takes candelas for watts over all directions, with 177.83 lumens per watt (daylight D65).
WATTS_PER_CANDELA = 4 * math.pi / 177.83
# Sine of the angle to the vertical below which Lightning counts a direction as vertical.
NEARLY_VERTICAL = 1e-6


def emission(light):
    """Returns the Emission node that is the only shader of a light's nodes; None if there is another one, or none."""
    output = light.node_tree.get_output_node("ALL") or light.node_tree.get_output_node("CYCLES") if light.use_nodes and light.node_tree else None
    return _source(output.inputs["Surface"], "ShaderNodeEmission") if output else None


def own_emission(light):
    """Returns the Emission node whose color and strength are the light's; None if they come from other nodes, or there is none."""
    node = emission(light)
    return node if node is not None and not any(node.inputs[name].is_linked for name in ("Color", "Strength")) else None


def black_body(light):
    """Returns the Blackbody node that gives a light its color; None if there is none, or if other nodes give its temperature."""
    node = emission(light)
    source = _source(node.inputs["Color"], "ShaderNodeBlackbody") if node is not None else None
    return source if source is not None and not source.inputs["Temperature"].is_linked else None


def color_and_strength(light, name: str, messages: list[str]) -> tuple[list[float], float]:
    """Returns what the nodes multiply a light by, except for its image, the shape of its profile, and its temperature."""
    node = emission(light)
    if node is None:
        if light.use_nodes and light.node_tree and any(link.to_socket.name == "Surface" for link in light.node_tree.links):
            messages.append(f"{name}: its nodes have other shaders than one Emission, and are not exchanged")
        return [1, 1, 1], 1
    color, strength = node.inputs["Color"], node.inputs["Strength"]
    profile = _profile(light, messages)
    if color.is_linked and image(light) is None and black_body(light) is None or strength.is_linked and profile is None:
        messages.append(f"{name}: its nodes are not exchanged, except for an image of an area light, an IES profile and a Blackbody")
    factor = 1 if strength.is_linked else strength.default_value
    if profile is not None:
        factor = _source(strength, "ShaderNodeTexIES").inputs["Strength"].default_value * profile.candela * WATTS_PER_CANDELA
    return list((1, 1, 1) if color.is_linked else color.default_value[:3]), factor


def _source(socket, kind: str):
    """Returns the node that is linked to a socket; None if it is of another kind."""
    node = socket.links[0].from_node if socket.links else None
    return node if node is not None and node.bl_idname == kind else None


def image(light):
    """Returns the image on the face of an area light; None if its nodes have none that fills the face."""
    node = emission(light)
    texture = _source(node.inputs["Color"], "ShaderNodeTexImage") if node is not None and light.type == "AREA" else None
    if texture is None or texture.image is None or texture.image.source not in ("FILE", "GENERATED") or texture.projection != "FLAT":
        return None
    if texture.inputs["Vector"].is_linked:
        link = texture.inputs["Vector"].links[0]
        if link.from_node.bl_idname != "ShaderNodeTexCoord" or link.from_socket.name != "UV":
            return None
    return texture.image


def texture_name(light) -> str:
    """Returns the name of the file with the image of an area light; empty if it has none."""
    shown = image(light)
    return "light-" + _safe(shown.name) + ".hdr" if shown is not None else ""


def write_texture(light, folder: Path, messages: list[str]) -> None:
    """Writes the image of an area light next to the scene file. Blender shows images on the lit side mirrored."""
    shown = image(light)
    if shown is not None:
        width, height, rgb = world.linear_pixels(shown, light.name, messages)
        mirrored = rgb.reshape(height, width, 3)[:, ::-1].reshape(-1, 3)
        (folder / texture_name(light)).write_bytes(world.radiance(width, height, mirrored))


def profile(obj) -> tuple[str, str]:
    """Returns the name and the text of a light's IES profile: of its nodes, times the soft edge of a spot. Two empty texts if there is none."""
    light = obj.data
    found = _profile(light, [])
    edge = spot_edge.points(light) if light.type == "SPOT" else None
    if found is None and edge is None:
        return "", ""
    name = f"spot-{math.degrees(light.spot_size):.4g}-blend-{light.spot_blend:.4g}" if edge is not None else ""
    if found is None:
        return f"{name}.ies", ies.write(ies.Profile([a for a, _ in edge], [0], [[v for _, v in edge]], 1))
    name = "-".join(filter(None, (name, _stem(_source(emission(light).inputs["Strength"], "ShaderNodeTexIES")))))
    if len(found.horizontal) > 1:
        turn = _turn(obj)
        name += f"-{turn:.6g}"
        found = ies.mirrored(found, turn)
    return f"{name}.ies", ies.write(ies.times(found, edge) if edge is not None else found)


def _turn(obj) -> float:
    """Returns the angle around the axis, in degrees as Cycles counts, at which Lightning starts to count.

    Cycles starts at -y of the light and turns to -x. Lightning has no roll of spots: it starts at the right as seen from the light, with
    the world's z at the top, and turns to the top. A point light looks straight down there, with -y at the top.
    """
    matrix = obj.matrix_world
    forward = -matrix.col[2].to_3d().normalized() if obj.data.type == "SPOT" else Vector((0, 0, -1))
    right = forward.cross(Vector((0, 0, 1)))
    if right.length < NEARLY_VERTICAL:
        right = forward.cross(Vector((0, -1, 0)))
    return round((270 - math.degrees(math.atan2(right.dot(matrix.col[1].to_3d().normalized()), right.dot(matrix.col[0].to_3d().normalized())))) % 360, 4)


def _stem(node) -> str:
    name = node.ies.name if node.mode == "INTERNAL" and node.ies else Path(node.filepath).name
    return _safe(Path(name).stem) or "profile"


def _safe(name: str) -> str:
    """Returns a name for a file."""
    return re.sub(r"[^\w-]", "_", name)


def _profile(light, messages: list[str]) -> ies.Profile | None:
    """Returns the IES profile of a light's nodes; None if there is none to send."""
    node = emission(light)
    texture = _source(node.inputs["Strength"], "ShaderNodeTexIES") if node is not None and light.type in ("POINT", "SPOT") else None
    if texture is None or texture.inputs["Vector"].is_linked:
        return None
    try:
        text = texture.ies.as_string() if texture.mode == "INTERNAL" and texture.ies else Path(
            bpy.path.abspath(texture.filepath)).read_text(encoding="latin-1")
        return ies.parse(text)
    except (OSError, ValueError, IndexError) as e:
        messages.append(f"the IES profile {_stem(texture)} is not sent: {e}")
        return None
