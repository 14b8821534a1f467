# SPDX-License-Identifier: Apache-2.0
"""Shaders that the exported materials do not have."""

import bpy

from . import materials
from .left_out import listed

# Shaders that are sent if they are all of a surface.
SENT = {"ShaderNodeBsdfPrincipled", "ShaderNodeBsdfGlass", "ShaderNodeBsdfRefraction"}


def notes(root: dict) -> list[str]:
    """Returns messages that name the materials with other shaders, and the shaders, and those with displacement."""
    found = []
    displaced = []
    for entry in root.get("materials", []):
        material = bpy.data.materials.get(entry.get("name", ""))
        shaders = _shaders(material) if material is not None and material.node_tree is not None else {}
        if shaders and not (len(shaders) == 1 and shaders.keys() <= SENT):
            found.append(f"{material.name} ({', '.join(dict.fromkeys(shaders.values()))})")
        if material is not None and material.node_tree is not None and materials.linked(material, "Displacement") is not None:
            displaced.append(material.name)
    messages = [f"shaders other than Principled BSDF are not sent exactly: {listed(found)}"] if found else []
    return messages + ([f"displacement is not sent: {listed(displaced)}"] if displaced else [])


def _shaders(material) -> dict[str, str]:
    """Returns the names of the shader nodes that a material's surface shows, by their type."""
    result: dict[str, str] = {}
    surface = materials.linked(material, "Surface")
    waiting, seen = [surface] if surface is not None else [], set()
    while waiting:
        node = waiting.pop()
        if node in seen:
            continue
        seen.add(node)
        if any(socket.type == "SHADER" for socket in node.outputs) and node.type not in ("GROUP", "REROUTE"):
            result[node.bl_idname] = node.bl_label
        if node.type == "GROUP" and node.node_tree is not None:
            waiting += [inner for inner in node.node_tree.nodes if inner.type == "GROUP_OUTPUT"]
        waiting += [link.from_node for socket in node.inputs if socket.type == "SHADER" for link in socket.links]
    return result
