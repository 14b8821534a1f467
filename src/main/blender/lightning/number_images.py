# SPDX-License-Identifier: Apache-2.0
"""Images of roughness and metalness as Blender's glTF exporter writes them: it takes a channel of an image and leaves out what nodes do to it."""

import bpy
import numpy

from . import links, model, node_values

# Channels in which glTF has these sockets.
CHANNELS = {"Roughness": "Green", "Metallic": "Blue"}


def of_material(material, copy, lost: dict, images: list):
    """Returns a copy of a material with images that have the values of its nodes; None if it can be exported as it is.

    Args:
        copy: a copy that is changed; None for a new one
        lost: receives what the copy does not show, by the name of the material
        images: receives new images, which the caller deletes
    """
    node = model.principled(copy or material)
    names = [name for name in CHANNELS if node is not None and not _is_exported(node.inputs[name])]
    if not names:
        return copy
    copy = copy or material.copy()
    node = model.principled(copy)
    notes = [note for note in (_simplify(copy.node_tree, node.inputs[name], images) for name in names) if note]
    if len({node_values.placement(found) for found in (_first_image(node.inputs[name]) for name in CHANNELS) if found is not None}) > 1:
        notes.append("coordinates of the image of Roughness, if they differ from those of Metallic")
    if notes:
        lost[material.name] = ", ".join([*filter(None, [lost.get(material.name)]), *notes])
    return copy


def _is_exported(socket) -> bool:
    """Returns whether the exporter writes what a socket shows: a constant, or a channel of an image, which a number may multiply."""
    output, path = links.source(socket, ())
    if output is None or output.node.bl_idname == "ShaderNodeValue":
        return True
    node = output.node
    if node.bl_idname == "ShaderNodeMath" and node.operation == "MULTIPLY" and not path:
        factors = [s for s in node.inputs[:2] if not s.is_linked]
        if len(factors) != 1 or not 0 <= factors[0].default_value <= 1:
            return False
        output, path = links.source(next(s for s in node.inputs[:2] if s.is_linked), path)
        node = output.node if output is not None else None
    if node is None or node.bl_idname != "ShaderNodeSeparateColor" or node.mode != "RGB" or path:
        return False
    output, path = links.source(node.inputs[0], path)
    image = output.node.image if output is not None and output.node.bl_idname == "ShaderNodeTexImage" and output.name == "Color" else None
    return image is not None and not path and (not node_values.has_pixels(image) or image.colorspace_settings.name != "sRGB" or image.is_float)


def _first_image(socket, path: tuple = (), depth: int = 0):
    """Returns the first image node whose values a socket has; None without one."""
    output, path = links.source(socket, path)
    if output is None or depth > links.DEPTH:
        return None
    if output.node.bl_idname == "ShaderNodeTexImage":
        return output.node
    return next(filter(None, (_first_image(s, path, depth + 1) for s in output.node.inputs)), None)


def _simplify(tree, socket, images: list) -> str:
    """Links an image of its values to a socket, or gives it their mean; returns a note about the mean."""
    values = node_values.Values()
    numbers = numpy.clip(values.number(socket), 0, 1)
    source = values.image_node
    if values.is_unreadable:
        return ""
    tree.links.remove(socket.links[0])
    if values.unknown or source is None:
        socket.default_value = float(numbers.mean())
        return f"{', '.join(values.unknown)} for {socket.name}, sent as the mean" if values.unknown else ""
    image = bpy.data.images.new(f"{source.image.name} {socket.name.lower()}", *source.image.size)
    images.append(image)
    pixels = numpy.ones((len(numbers), 4), dtype=numpy.float32)
    pixels[:, :3] = numbers[:, None]
    image.pixels.foreach_set(pixels.reshape(-1))
    _link(tree, socket, source, image)
    return ""


def _link(tree, socket, source, image) -> None:
    """Links an image to a socket, placed like another one."""
    texture, channels = tree.nodes.new("ShaderNodeTexImage"), tree.nodes.new("ShaderNodeSeparateColor")
    texture.image, texture.extension, texture.interpolation = image, source.extension, source.interpolation
    if source.inputs["Vector"].is_linked:
        tree.links.new(source.inputs["Vector"].links[0].from_socket, texture.inputs["Vector"])
    tree.links.new(texture.outputs["Color"], channels.inputs[0])
    tree.links.new(channels.outputs[CHANNELS[socket.name]], socket)
