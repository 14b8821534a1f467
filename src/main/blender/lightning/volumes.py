# SPDX-License-Identifier: Apache-2.0
"""Volumes: those with the same content everywhere become Lightning's fog, of the world or of one box."""

from . import axes

# Largest mean cosine of Lightning.
MOST_ANISOTROPY = 0.9
# Largest distance of a vertex from a corner of its box, relative to the largest side.
FLATNESS = 1e-4


def has_only_volume(obj) -> bool:
    """Returns whether an object's materials have volumes and no surfaces."""
    outputs = [_output(slot.material) for slot in obj.material_slots if slot.material is not None]
    return bool(outputs) and all(output is not None and output.inputs["Volume"].is_linked and not output.inputs["Surface"].is_linked
                                 for output in outputs)


def _output(block):
    tree = block.node_tree
    return tree and (tree.get_output_node("ALL") or tree.get_output_node("CYCLES"))


def fog(block, name: str, messages: list[str]) -> dict:
    """Returns the volume of a material or a world as Lightning's fog; nothing if it has none, or one that no fog is like."""
    output = _output(block)
    links = output.inputs["Volume"].links if output is not None else ()
    if not links:
        return {}
    node = links[0].from_node
    kinds = {"ShaderNodeVolumePrincipled": _principled, "ShaderNodeVolumeScatter": _scatter, "ShaderNodeVolumeAbsorption": _absorption}
    create = kinds.get(node.bl_idname)
    if create is None or any(socket.is_linked for socket in node.inputs):
        messages.append(f"{name}: only a volume with the same content everywhere is sent, as fog")
        return {}
    density, color = create(node, name, messages)
    anisotropy = axes.number(node.inputs["Anisotropy"].default_value) if "Anisotropy" in node.inputs else 0
    if abs(anisotropy) > MOST_ANISOTROPY:
        messages.append(f"{name}: the anisotropy of its volume became {MOST_ANISOTROPY}")
        anisotropy = max(-MOST_ANISOTROPY, min(MOST_ANISOTROPY, anisotropy))
    return {"fog": max(density, 0), "fog_color": [min(max(c, 0), 1) for c in color], "fog_anisotropy": anisotropy,
            "fog_ambient": [0, 0, 0], "fog_falloff": 0, "fog_size": [0, 0, 0]}


def _color(node, name: str) -> list[float]:
    return [axes.number(c) for c in node.inputs[name].default_value[:3]]


def _principled(node, name: str, messages: list[str]) -> tuple[float, list[float]]:
    if any(node.inputs[key].default_value > 0 for key in ("Emission Strength", "Blackbody Intensity")):
        messages.append(f"{name}: its volume does not glow in Lightning")
    density = axes.number(node.inputs["Density"].default_value)
    color = _color(node, "Color")
    # Cycles absorbs (1 − color) · (1 − √absorption color).
    lost = [max(1 - c, 0) * max(1 - max(a, 0) ** 0.5, 0) for c, a in zip(color, _color(node, "Absorption Color"))]
    return _mean(name, density, color, lost, messages)


def _scatter(node, name: str, messages: list[str]) -> tuple[float, list[float]]:
    if node.phase != "HENYEY_GREENSTEIN":
        messages.append(f"{name}: its volume scatters as one of Henyey and Greenstein")
    return _mean(name, axes.number(node.inputs["Density"].default_value), _color(node, "Color"), [0, 0, 0], messages)


def _absorption(node, name: str, messages: list[str]) -> tuple[float, list[float]]:
    lost = [max(1 - c, 0) for c in _color(node, "Color")]
    return _mean(name, axes.number(node.inputs["Density"].default_value), [0, 0, 0], lost, messages)


def _mean(name: str, density: float, scattered: list[float], lost: list[float], messages: list[str]) -> tuple[float, list[float]]:
    """Returns the density, which Lightning has once for all colors, and the share of light that is scattered."""
    together = [s + a for s, a in zip(scattered, lost)]
    if max(together) - min(together) > 1e-4 * max(together):
        messages.append(f"{name}: its volume is as dense for all colors in Lightning")
    mean = sum(together) / 3
    return density * mean, [s / mean if mean > 0 else 0 for s in scattered]


def box(mesh, matrix) -> tuple[list[float], list[float]] | None:
    """Returns the center and the size of a mesh that is a box along the axes, in Lightning's axes; None if it is none."""
    corners = [matrix @ vertex.co for vertex in mesh.vertices]
    if len(corners) != 8:
        return None
    low = [min(c[i] for c in corners) for i in range(3)]
    high = [max(c[i] for c in corners) for i in range(3)]
    size = [h - l for l, h in zip(low, high)]
    sides = set()
    for corner in corners:
        if any(min(corner[i] - low[i], high[i] - corner[i]) > FLATNESS * max(size) for i in range(3)):
            return None
        sides.add(tuple(corner[i] - low[i] > size[i] / 2 for i in range(3)))
    center = [(l + h) / 2 for l, h in zip(low, high)]
    return ([center[0], center[2], -center[1]], [size[0], size[2], size[1]]) if len(sides) == 8 else None
