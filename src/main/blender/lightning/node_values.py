# SPDX-License-Identifier: Apache-2.0
"""Values that nodes between an image and a shader compute, for all pixels together.

Numbers are arrays of one value for each pixel, or of one value for all. Colors have three columns.
"""

import numpy

from . import links

# Weights of the luminance to which Cycles converts colors, Rec. 709.
GRAY = numpy.array([0.2126, 0.7152, 0.0722], dtype=numpy.float32)
RAMP_SIZE = 256


class Values:
    """Computes values of sockets. All of them read the same texture coordinates of images of one size."""

    def __init__(self) -> None:
        # The first image node, and what was not computed; a dict keeps the order.
        self.image_node = None
        self.unknown: dict[str, None] = {}
        # Whether an image has tiles, frames or no pixels.
        self.is_unreadable = False

    def number(self, socket, path: tuple = (), depth: int = 0):
        """Returns the numbers of a socket."""
        value = self._value(socket, path, depth)
        return value @ GRAY if value.ndim == 2 else value

    def color(self, socket, path: tuple, depth: int):
        """Returns the colors of a socket."""
        value = self._value(socket, path, depth)
        return value if value.ndim == 2 else numpy.repeat(value[:, None], 3, axis=1)

    def _value(self, socket, path: tuple, depth: int):
        output, place = links.source(socket, path)
        if output is None:
            return constant(links.outermost(socket, path).default_value)
        node = output.node
        if node.bl_idname in links.CONSTANTS:
            return constant(output.default_value)
        if node.bl_idname == "ShaderNodeTexImage" and self._is_readable(node, place):
            return self._image(node, output.name)
        compute = NODES.get(node.bl_idname)
        if compute is not None and depth < links.DEPTH:
            value = compute(Inputs(self, node, place, depth + 1), node, output)
            if value is not None:
                return value
        self.unknown[node.bl_label] = None
        linked = next((s for s in node.inputs if s.is_linked and s.type in ("VALUE", "RGBA")), None)
        return self._value(linked, place, depth + 1) if linked is not None and depth < links.DEPTH else constant(0.5)

    def _is_readable(self, node, path: tuple) -> bool:
        if not has_pixels(node.image):
            self.is_unreadable = True
            return False
        # Another node cannot have the coordinates of one in a group.
        return node.projection == "FLAT" and not (path and node.inputs["Vector"].is_linked) and (
            self.image_node is None or placement(self.image_node) == placement(node) and tuple(self.image_node.image.size) == tuple(node.image.size))

    def _image(self, node, output: str):
        if self.image_node is None:
            self.image_node = node
        pixels = numpy.empty(4 * node.image.size[0] * node.image.size[1], dtype=numpy.float32)
        node.image.pixels.foreach_get(pixels)
        pixels = pixels.reshape(-1, 4)
        return pixels[:, 3] if output == "Alpha" else _linear(pixels[:, :3], node.image)


class Inputs:
    """Values of the inputs of a node."""

    def __init__(self, values: Values, node, path: tuple, depth: int) -> None:
        self._values = values
        self._node = node
        self._path = path
        self._depth = depth

    def number(self, name):
        """Returns the numbers of an input, by its name or index."""
        return self._values.number(self._node.inputs[name], self._path, self._depth)

    def color(self, name):
        """Returns the colors of an input, by its name or index."""
        return self._values.color(self._node.inputs[name], self._path, self._depth)

    def of_type(self, kind: str, number: int):
        """Returns an input of a node with inputs of several types."""
        socket = [s for s in self._node.inputs if s.type == kind][number]
        read = self._values.color if kind == "RGBA" else self._values.number
        return read(socket, self._path, self._depth)


def placement(node) -> tuple:
    """Returns what places an image: its coordinates and what follows its edges."""
    output, _ = links.source(node.inputs["Vector"], ())
    return (output.node.name, output.identifier) if output is not None else None, node.extension


def has_pixels(image) -> bool:
    """Returns whether the pixels of an image are known."""
    return image is not None and image.source in ("FILE", "GENERATED") and min(image.size) > 0


def constant(value):
    """Returns a number or a color as values."""
    return numpy.array([value[:3]] if hasattr(value, "__len__") else [value], dtype=numpy.float32)


def _linear(colors, image):
    # Blender converts only images of floats.
    if image.is_float or image.colorspace_settings.name != "sRGB":
        return colors
    return numpy.where(colors <= 0.04045, colors / 12.92, ((numpy.maximum(colors, 0.04045) + 0.055) / 1.055) ** 2.4).astype(numpy.float32)


def _separated(inputs: Inputs, node, output):
    if getattr(node, "mode", "RGB") != "RGB":
        return None
    return inputs.color(0)[:, node.outputs[:].index(output)]


def _inverted(inputs: Inputs, _node, _output):
    share, color = inputs.number(0)[:, None], inputs.color(1)
    return share * (1 - color) + (1 - share) * color


def _computed(inputs: Inputs, node, _output):
    if node.operation not in OPERATIONS:
        return None
    count, compute = OPERATIONS[node.operation]
    with numpy.errstate(all="ignore"):
        result = numpy.nan_to_num(compute(*(inputs.number(i) for i in range(count))), posinf=0, neginf=0)
    return numpy.clip(result, 0, 1) if node.use_clamp else result


def _mapped(inputs: Inputs, node, _output):
    if node.data_type != "FLOAT" or node.interpolation_type != "LINEAR":
        return None
    value, low, high, start, end = (inputs.number(i) for i in range(5))
    span = high - low
    share = numpy.where(span == 0, 0, (value - low) / numpy.where(span == 0, 1, span))
    result = start + share * (end - start)
    return numpy.clip(result, numpy.minimum(start, end), numpy.maximum(start, end)) if node.clamp else result


def _clamped(inputs: Inputs, node, _output):
    value, low, high = (inputs.number(i) for i in range(3))
    if node.clamp_type == "RANGE":
        low, high = numpy.minimum(low, high), numpy.maximum(low, high)
    return numpy.minimum(numpy.maximum(value, low), high)


def _ramp(inputs: Inputs, node, output):
    table = numpy.array([node.color_ramp.evaluate(i / (RAMP_SIZE - 1)) for i in range(RAMP_SIZE)], dtype=numpy.float32)
    place = numpy.clip(inputs.number(0), 0, 1) * (RAMP_SIZE - 1)
    below = numpy.minimum(place.astype(numpy.int32), RAMP_SIZE - 2)
    share = (place - below)[:, None]
    colors = table[below] * (1 - share) + table[below + 1] * share
    return colors[:, 3] if output.name == "Alpha" else colors[:, :3]


def _contrast(inputs: Inputs, _node, _output):
    slope = 1 + inputs.number("Contrast")[:, None]
    return numpy.maximum(slope * inputs.color("Color") + inputs.number("Bright")[:, None] - (slope - 1) / 2, 0)


def _mixed(inputs: Inputs, node, _output):
    kind = {"FLOAT": "VALUE", "RGBA": "RGBA"}.get(node.data_type)
    blend = BLENDS.get(node.blend_type if kind == "RGBA" else "MIX")
    if kind is None or blend is None:
        return None
    # The first factor is of type FLOAT; two more numbers are A and B.
    share = inputs.of_type("VALUE", 0)
    share = numpy.clip(share, 0, 1) if node.clamp_factor else share
    first, second = (inputs.of_type(kind, i + (1 if kind == "VALUE" else 0)) for i in range(2))
    share = share[:, None] if kind == "RGBA" else share
    result = (1 - share) * first + share * blend(first, second)
    return numpy.clip(result, 0, 1) if kind == "RGBA" and node.clamp_result else result


# For each operation: the number of inputs that it reads, and its function.
OPERATIONS = {
    "ADD": (2, lambda a, b: a + b), "SUBTRACT": (2, lambda a, b: a - b), "MULTIPLY": (2, lambda a, b: a * b), "DIVIDE": (2, lambda a, b: a / b),
    "MULTIPLY_ADD": (3, lambda a, b, c: a * b + c), "POWER": (2, lambda a, b: a ** b), "MINIMUM": (2, numpy.minimum),
    "MAXIMUM": (2, numpy.maximum), "ABSOLUTE": (1, numpy.abs), "SQRT": (1, numpy.sqrt),
    "GREATER_THAN": (2, lambda a, b: (a > b).astype(numpy.float32)), "LESS_THAN": (2, lambda a, b: (a < b).astype(numpy.float32)),
}
BLENDS = {"MIX": lambda _, b: b, "MULTIPLY": lambda a, b: a * b, "ADD": lambda a, b: a + b, "SUBTRACT": lambda a, b: a - b}
NODES = {
    "ShaderNodeSeparateColor": _separated, "ShaderNodeSeparateXYZ": _separated, "ShaderNodeInvert": _inverted, "ShaderNodeMath": _computed,
    "ShaderNodeMapRange": _mapped, "ShaderNodeClamp": _clamped, "ShaderNodeValToRGB": _ramp, "ShaderNodeBrightContrast": _contrast,
    "ShaderNodeMix": _mixed, "ShaderNodeRGBToBW": lambda inputs, _node, _output: inputs.color(0) @ GRAY,
    "ShaderNodeGamma": lambda inputs, _node, _output: numpy.maximum(inputs.color(0), 0) ** inputs.number(1)[:, None],
}
