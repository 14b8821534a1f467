# SPDX-License-Identifier: Apache-2.0
"""Images of numbers and reflected colors as Blender's glTF exporter writes them: it takes an image and leaves out what nodes do to it."""

import bpy
import numpy

from . import links, model, node_values

# Channels from which the exporter takes these sockets; it writes those of levels and of sheens to alpha.
CHANNELS = {"Roughness": "Green", "Metallic": "Blue", "Coat Weight": "Red", "Coat Roughness": "Green", "Specular IOR Level": "Red",
            "Sheen Roughness": "Red"}
# Sockets whose image glTF has in one file.
PACKED = ("Roughness", "Metallic")
# Sockets whose product is the color of a sheen.
SHEEN = ("Sheen Weight", "Sheen Tint")


def of_material(material, copy, lost: dict, images: list):
    """Returns a copy of a material with images that have the values of its nodes; None if it can be exported as it is.

    Args:
        copy: a copy that is changed; None for a new one
        lost: receives what the copy does not show, by the name of the material
        images: receives new images, which the caller deletes
    """
    node = model.principled(copy or material)
    names = [name for name in CHANNELS if node is not None and not _is_exported(node.inputs[name])]
    has_colors = node is not None and any(node.inputs[name].is_linked for name in ("Specular Tint", *SHEEN))
    if not names and not has_colors:
        return copy
    copy = copy or material.copy()
    node = model.principled(copy)
    notes = [note for note in (_simplify(copy.node_tree, node.inputs[name], images) for name in names) if note]
    notes += _simplify_colors(copy.node_tree, node, images)
    if len({node_values.placement(found) for found in (_first_image(node.inputs[name]) for name in PACKED) if found is not None}) > 1:
        notes.append("coordinates of the image of Roughness, if they differ from those of Metallic")
    if notes:
        lost[material.name] = ", ".join([*filter(None, [lost.get(material.name)]), *notes])
    return copy


def _is_exported(socket) -> bool:
    """Returns whether the exporter writes what a socket shows: a constant, or a channel of an image, which a number may multiply."""
    output, path = links.source(socket, ())
    if output is None or output.node.bl_idname == "ShaderNodeValue":
        return True
    if socket.name == "Specular IOR Level":
        # The exporter doubles the factors of some images only.
        return False
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
    channels = tree.nodes.new("ShaderNodeSeparateColor")
    tree.links.new(_image_node(tree, source, socket.name, numbers[:, None], images).outputs["Color"], channels.inputs[0])
    tree.links.new(channels.outputs[CHANNELS[socket.name]], socket)
    return ""


def _simplify_colors(tree, node, images: list) -> list[str]:
    """Links images of their values to the colors of a reflection and of a sheen, or gives them their mean; returns notes about means."""
    notes = []
    tint = node.inputs["Specular Tint"]
    if tint.is_linked and tint.links[0].from_node.bl_idname != "ShaderNodeTexImage":
        values = node_values.Values()
        notes.append(_set_color(tree, tint, values.color(tint, (), 0), values, images))
    weight, color = (node.inputs[name] for name in SHEEN)
    if weight.is_linked or color.is_linked:
        values = node_values.Values()
        product = values.number(weight)[:, None] * values.color(color, (), 0)
        if not values.is_unreadable:
            for link in (*weight.links, *color.links):
                tree.links.remove(link)
            weight.default_value = 1
            notes.append(_set_color(tree, color, product, values, images))
    return [note for note in notes if note]


def _set_color(tree, socket, colors, values, images: list) -> str:
    """Links an image of colors to a socket, or gives it their mean; returns a note about the mean."""
    if values.is_unreadable:
        return ""
    for link in socket.links:
        tree.links.remove(link)
    colors = numpy.clip(colors, 0, 1)
    if values.unknown or values.image_node is None:
        socket.default_value = (*map(float, colors.mean(axis=0)), 1.0)
        return f"{', '.join(values.unknown)} for {socket.name}, sent as the mean" if values.unknown else ""
    curved = numpy.where(colors <= 0.0031308, colors * 12.92, 1.055 * numpy.maximum(colors, 0.0031308) ** (1 / 2.4) - 0.055)
    tree.links.new(_image_node(tree, values.image_node, socket.name, curved, images).outputs["Color"], socket)
    return ""


def _image_node(tree, source, name: str, colors, images: list):
    """Returns a new node with an image of colors or grays, placed like another one."""
    image = bpy.data.images.new(f"{source.image.name} {name.lower()}", *source.image.size)
    images.append(image)
    pixels = numpy.ones((len(colors), 4), dtype=numpy.float32)
    pixels[:, :3] = colors
    image.pixels.foreach_set(pixels.reshape(-1))
    texture = tree.nodes.new("ShaderNodeTexImage")
    texture.image, texture.extension, texture.interpolation = image, source.extension, source.interpolation
    if source.inputs["Vector"].is_linked:
        tree.links.new(source.inputs["Vector"].links[0].from_socket, texture.inputs["Vector"])
    return texture
