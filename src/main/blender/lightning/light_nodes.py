# SPDX-License-Identifier: Apache-2.0
"""Node trees of lights: one Emission, whose color can be an image and whose strength an IES profile."""

import bisect
import math
import re
from pathlib import Path

import bpy

from . import world

# Cycles takes candelas for watts over all directions, with 177.83 lumens per watt (daylight D65).
WATTS_PER_CANDELA = 4 * math.pi / 177.83
# Angles at which a soft edge of a spot is described.
EDGE_STEPS = 64


def emission(light):
    """Returns the Emission node that is the only shader of a light's nodes; None if there is another one, or none."""
    output = light.node_tree.get_output_node("ALL") or light.node_tree.get_output_node("CYCLES") if light.use_nodes and light.node_tree else None
    return _source(output.inputs["Surface"], "ShaderNodeEmission") if output else None


def own_emission(light):
    """Returns the Emission node whose color and strength are the light's; None if they come from other nodes, or there is none."""
    node = emission(light)
    return node if node is not None and not any(node.inputs[name].is_linked for name in ("Color", "Strength")) else None


def color_and_strength(light, name: str, messages: list[str]) -> tuple[list[float], float]:
    """Returns what the nodes multiply a light by, except for its image and the shape of its profile."""
    node = emission(light)
    if node is None:
        if light.use_nodes and light.node_tree and any(link.to_socket.name == "Surface" for link in light.node_tree.links):
            messages.append(f"{name}: its nodes have other shaders than one Emission, and are not exchanged")
        return [1, 1, 1], 1
    color, strength = node.inputs["Color"], node.inputs["Strength"]
    profile = _profile(light, messages)
    if color.is_linked and image(light) is None or strength.is_linked and profile is None:
        messages.append(f"{name}: its nodes are not exchanged, except for an image of an area light and an IES profile")
    factor = 1 if strength.is_linked else strength.default_value
    if profile is not None:
        factor = _source(strength, "ShaderNodeTexIES").inputs["Strength"].default_value * profile[1] * WATTS_PER_CANDELA
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


def profile(light) -> tuple[str, str]:
    """Returns the name and the text of a light's IES profile: of its nodes, times the soft edge of a spot. Two empty texts if there is none."""
    found = _profile(light, [])
    edge = _edge(light) if light.type == "SPOT" else None
    if found is None and edge is None:
        return "", ""
    name = f"spot-{math.degrees(light.spot_size):.4g}-blend-{light.spot_blend:.4g}" if edge is not None else ""
    points = edge
    if found is not None:
        points = found[0]
        source = _source(emission(light).inputs["Strength"], "ShaderNodeTexIES")
        name = "-".join(filter(None, (name, _stem(source))))
        if edge is not None:
            angles = sorted({a for a, _ in points} | {a for a, _ in edge})
            points = [(a, _at(points, a) * _at(edge, a)) for a in angles if points[0][0] <= a <= edge[-1][0]]
    lines = ["IESNA:LM-63-2002", "TILT=NONE", f"1 -1 1 {len(points)} 1 1 2 0 0 0", "1 1 1"]
    lines += [f"{math.degrees(a):.9g}" for a, _ in points] + ["0"] + [f"{v:.9g}" for _, v in points]
    return f"{name}.ies", "\r\n".join(lines) + "\r\n"


def _stem(node) -> str:
    name = node.ies.name if node.mode == "INTERNAL" and node.ies else Path(node.filepath).name
    return _safe(Path(name).stem) or "profile"


def _safe(name: str) -> str:
    """Returns a name for a file."""
    return re.sub(r"[^\w-]", "_", name)


def _edge(light) -> list[tuple[float, float]] | None:
    """Returns the soft edge of a spot as angles and shares of its light; None if its edge is sharp.

    The light falls from 1 to 0 as 3t² - 2t³, where t is linear in the cosine. Between 64 angles the profile is linear, with an error of
    less than 0.0002.
    """
    half = light.spot_size / 2
    if light.spot_blend <= 0 or half >= math.pi / 2:
        return None
    outer = math.cos(half)
    inner = math.acos(min(1.0, outer + (1 - outer) * light.spot_blend))
    angles = [inner + (half - inner) * i / EDGE_STEPS for i in range(EDGE_STEPS + 1)]
    if angles[0] > 1e-6:
        angles.insert(0, 0.0)
    result = []
    for angle in angles:
        t = min(max((math.cos(angle) - outer) / ((1 - outer) * light.spot_blend), 0), 1)
        result.append((angle, t * t * (3 - 2 * t)))
    return result


def _at(points: list[tuple[float, float]], angle: float) -> float:
    """Returns a value between the angles of a profile."""
    i = min(max(bisect.bisect_right([a for a, _ in points], angle), 1), len(points) - 1)
    (a, v), (b, w) = points[i - 1], points[i]
    return v + (w - v) * min(max((angle - a) / (b - a), 0), 1) if b > a else v


def _profile(light, messages: list[str]) -> tuple[list[tuple[float, float]], float] | None:
    """Returns the angles and values of the IES profile of a light's nodes, and its largest value in candelas; None if there is none to send."""
    node = emission(light)
    texture = _source(node.inputs["Strength"], "ShaderNodeTexIES") if node is not None and light.type in ("POINT", "SPOT") else None
    if texture is None or texture.inputs["Vector"].is_linked:
        return None
    try:
        text = texture.ies.as_string() if texture.mode == "INTERNAL" and texture.ies else Path(
            bpy.path.abspath(texture.filepath)).read_text(encoding="latin-1")
        return _parse(text)
    except (OSError, ValueError, IndexError) as e:
        messages.append(f"the IES profile {_stem(texture)} is not sent: {e}")
        return None


def _parse(text: str) -> tuple[list[tuple[float, float]], float]:
    """Reads a profile of LM-63 that is the same in all horizontal directions; a ValueError says why one is not."""
    found = re.search(r"^TILT=NONE\s*$", text, re.MULTILINE)
    if found is None:
        raise ValueError("expected TILT=NONE")
    numbers = [float(word) for word in text[found.end():].replace(",", " ").split()]
    multiplier, vertical, horizontal, photometry = numbers[2], int(numbers[3]), int(numbers[4]), int(numbers[5])
    if photometry != 1 or horizontal != 1 or vertical < 2:
        raise ValueError("expected photometry of type C with one horizontal angle")
    angles = [math.radians(a) for a in numbers[13:13 + vertical]]
    scale = multiplier * numbers[10] * numbers[11]
    values = [v * scale for v in numbers[14 + vertical:14 + 2 * vertical]]
    brightest = max(values)
    if len(values) != vertical or angles != sorted(angles) or not brightest > 0:
        raise ValueError("expected ascending angles and a value for each")
    return [(a, v / brightest) for a, v in zip(angles, values)], brightest
