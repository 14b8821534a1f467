# SPDX-License-Identifier: Apache-2.0
"""Values that nodes without images give a Principled BSDF: Blender's glTF exporter leaves most of them out."""

from . import links, model, node_values

# Sockets that glTF has a texture for, which the exporter writes.
TEXTURED = ("Base Color", "Alpha", "Specular IOR Level", "Specular Tint", "Transmission Weight", "Coat Weight", "Coat Roughness", "Sheen Tint", "Sheen Roughness",
            "Emission Color")
SOCKETS = (*TEXTURED, "Sheen Weight", "IOR", "Coat IOR", "Emission Strength")
NORMALS = ("Normal", "Coat Normal")
# Nodes that the exporter writes as colors of vertices.
VERTEX_COLORS = {"Color Attribute", "Attribute"}


def of_material(material, copy, lost: dict):
    """Returns a copy of a material whose sockets have the values of their nodes; None if it can be exported as it is.

    Args:
        copy: a copy that is changed; None for a new one
        lost: receives what the copy does not show, by the name of the material
    """
    node = model.principled(copy or material)
    names = [name for name in (*SOCKETS, *NORMALS) if node is not None and node.inputs[name].is_linked]
    if not names:
        return copy
    copy = copy or material.copy()
    node = model.principled(copy)
    notes = [note for note in (_note_normal(node, name) if name in NORMALS else _replace(copy.node_tree, node.inputs[name]) for name in names)
             if note]
    if notes:
        lost[material.name] = ", ".join([*filter(None, [lost.get(material.name)]), *notes])
    return copy


def _replace(tree, socket) -> str:
    """Gives a socket the mean value of its nodes, unless the exporter writes their image; returns a note about the mean."""
    values = node_values.Values()
    found = (values.color if socket.type == "RGBA" else values.number)(socket, (), 0)
    has_image = values.image_node is not None or values.is_unreadable
    if has_image and socket.name in TEXTURED or socket.name == "Base Color" and values.unknown.keys() & VERTEX_COLORS:
        return ""
    tree.links.remove(socket.links[0])
    mean = found.mean(axis=0)
    socket.default_value = (*map(float, mean), 1.0) if socket.type == "RGBA" else float(mean)
    labels = [*values.unknown, *(["Image Texture"] if has_image else [])]
    return f"{', '.join(labels)} for {socket.name}, sent as the mean" if labels else ""


def _note_normal(node, name: str) -> str:
    """Returns a note if the normals of a socket are not those of an image."""
    output, _ = links.source(node.inputs[name], ())
    if name == "Coat Normal" and not node.inputs["Coat Weight"].is_linked and node.inputs["Coat Weight"].default_value == 0:
        return ""
    return "" if output is None or output.node.bl_idname == "ShaderNodeNormalMap" else f"{output.node.bl_label} for {name}, not sent"
