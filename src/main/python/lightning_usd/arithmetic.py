"""MaterialX nodes that multiply the numbers of an image by constants and add constants."""

from __future__ import annotations

from typing import Any

CHANNELS = 4
# scale · x + bias, for each channel.
Linear = tuple[list[float], list[float]]


def linear(kind: str, constants: dict[str, list[float]]) -> Linear | None:
    """Returns what a node does to the input that is no constant; None for nodes that do something else."""
    name = kind.removeprefix("ND_").split("_")[0]
    inputs = Inputs(constants)
    if name == "multiply":
        return inputs.of("in2" if "in2" in constants else "in1", 1.0), inputs.filled(0.0)
    if name == "divide" and "in2" in constants and all(inputs.of("in2", 1.0)):
        return [1 / v for v in inputs.of("in2", 1.0)], inputs.filled(0.0)
    if name == "add":
        return inputs.filled(1.0), inputs.of("in2" if "in2" in constants else "in1", 0.0)
    if name == "subtract" and "in2" in constants:
        return inputs.filled(1.0), [-v for v in inputs.of("in2", 0.0)]
    if name == "subtract":
        return inputs.filled(-1.0), inputs.of("in1", 0.0)
    if name == "invert":
        return inputs.filled(-1.0), inputs.of("amount", 1.0)
    if name == "remap" or name == "range" and constants.get("gamma", [1.0]) == [1.0] and not any(constants.get("doclamp", [0.0])):
        return inputs.remap()
    return None


class Inputs:
    """Constant inputs of a node, each as a list of four channels."""

    def __init__(self, constants: dict[str, list[float]]) -> None:
        self.constants = constants

    def of(self, name: str, fallback: float) -> list[float]:
        """Returns a constant; a single number counts for all channels."""
        found = self.constants.get(name, [fallback])
        return self.filled(found[0]) if len(found) == 1 else [*found, *self.filled(fallback)][:CHANNELS]

    def filled(self, value: float) -> list[float]:
        """Returns a number for all channels."""
        return [value] * CHANNELS

    def remap(self) -> Linear | None:
        """Returns the map from the range inlow … inhigh to outlow … outhigh; None for an empty range."""
        lows, highs = self.of("inlow", 0.0), self.of("inhigh", 1.0)
        if any(low == high for low, high in zip(lows, highs)):
            return None
        targets = self.of("outlow", 0.0)
        slopes = [(top - target) / (high - low) for low, high, target, top in zip(lows, highs, targets, self.of("outhigh", 1.0))]
        return slopes, [target - slope * low for low, target, slope in zip(lows, targets, slopes)]


def apply(texture: dict[str, Any], steps: list[Linear]) -> None:
    """Changes the scale and bias of a texture by steps; the first step is the one next to the surface."""
    for scale, bias in reversed(steps):
        texture["scale"] = [s * v for s, v in zip(scale, texture.get("scale", [1.0] * CHANNELS))]
        texture["bias"] = [s * v + b for s, b, v in zip(scale, bias, texture.get("bias", [0.0] * CHANNELS))]
