"""A view as a lattice of colors over a logarithm, and how far it is from the exact view.

Lightning reads the table with `Log2Shaper` and `CubeLut`; `Table.color` computes the same.
"""

from __future__ import annotations

import json
import math
import random
from array import array
from dataclasses import dataclass
from pathlib import Path

SIZE = 65
MIDDLE_GRAY = 0.18
CODES = 255
MAX_STOPS = 20
"""Largest range of the logarithm on each side of middle gray."""
STEPS_PER_STOP = 4
UNSEEN = 0.5
"""Codes by which a color may change outside the range of the logarithm."""
RANGE_COLORS = 4000
TEST_COLORS = 20000
LEAST, MOST = -1.0, 2.0
"""Bounds of the stored values. Displays show 0 to 1; values outside keep the interpolation next to 0 and 1 smooth."""


class NoNumberError(Exception):
    """A conversion gives NaN or infinity for light."""


@dataclass
class Table:
    """A lattice over stops around middle gray, with its error in codes of 8 bits."""

    low: float
    high: float
    colors: array
    largest: float = 0.0
    percentile99: float = 0.0
    mean: float = 0.0

    @staticmethod
    def bake(processor) -> Table:
        """Makes the table of a conversion from linear light; measures its error."""
        low, high = used_range(processor)
        axis = [0.0] + [MIDDLE_GRAY * 2 ** (low + (high - low) * i / (SIZE - 1)) for i in range(1, SIZE)]
        light = array("f", [v for b in axis for g in axis for r in axis for v in (r, g, b)])
        table = Table(low, high, exact(processor, light, LEAST, MOST))
        table.measure(processor)
        return table

    def measure(self, processor) -> None:
        """Compares with the exact conversion at random colors within the range."""
        stops = random_stops(TEST_COLORS, self.low, self.high, seed=2)
        shown = exact(processor, light_of(stops))
        errors = []
        for i in range(0, len(stops), 3):
            color = self.color(stops[i], stops[i + 1], stops[i + 2])
            errors.append(CODES * max(abs(min(max(color[c], 0), 1) - shown[i + c]) for c in range(3)))
        errors.sort()
        self.largest = errors[-1]
        self.percentile99 = errors[len(errors) * 99 // 100]
        self.mean = sum(errors) / len(errors)

    def color(self, *stops: float) -> list[float]:
        """Returns the interpolated color: from a corner of the cell along the axes, the largest fraction first."""
        corner = 0
        steps = []
        for axis in range(3):
            at = min(max((stops[axis] - self.low) / (self.high - self.low), 0), 1) * (SIZE - 1)
            cell = min(int(at), SIZE - 2)
            stride = 3 * SIZE ** axis
            corner += cell * stride
            steps.append((at - cell, stride))
        steps.sort(reverse=True)
        weight = 1 - steps[0][0]
        color = [weight * self.colors[corner + c] for c in range(3)]
        for i, (share, stride) in enumerate(steps):
            corner += stride
            weight = share - (steps[i + 1][0] if i < 2 else 0)
            for c in range(3):
                color[c] += weight * self.colors[corner + c]
        return color

    def facts(self) -> dict:
        """Returns the range in stops, and the errors in codes of 8 bits."""
        return {"low": self.low, "high": self.high, "largestError": self.largest, "error99": self.percentile99, "meanError": self.mean,
                "colors": TEST_COLORS}

    def write_cube(self, file: Path, source: str, display: str, view: str, note: str) -> None:
        """Writes a .cube file; its comments say where it comes from, and the logarithm before it."""
        # JSON escapes line breaks, which would end a comment.
        lines = [f"# OpenColorIO view {json.dumps(view[:80])} of display {json.dumps(display[:80])}, baked from {json.dumps(source)}",
                 f"# Input: linear Rec. 709, then log2(x / {MIDDLE_GRAY}) from {self.low} to {self.high} stops as 0 to 1",
                 f"# Error in steps of 8 bits at {TEST_COLORS} random colors: mean {self.mean:.3f}, 99 % below {self.percentile99:.2f}, "
                 f"largest {self.largest:.2f}",
                 *([f"# Note: {note}"] if note else []),
                 f"# LIGHTNING_SHAPER log2:{self.low},{self.high}",
                 f"LUT_3D_SIZE {SIZE}"]
        with open(file, "w", encoding="ascii", newline="\n") as out:
            out.write("\n".join(lines) + "\n" + "%.7g %.7g %.7g\n" * (len(self.colors) // 3) % tuple(self.colors))


def used_range(processor) -> tuple[float, float]:
    """Returns stops outside of which colors do not change visibly: below the first they look like 0, above the second like it."""
    stops = random_stops(RANGE_COLORS, -MAX_STOPS, MAX_STOPS, seed=1)
    shown = exact(processor, light_of(stops))

    def unseen(limited: array) -> bool:
        return all(abs(a - b) * CODES <= UNSEEN for a, b in zip(exact(processor, limited), shown))

    def search(is_enough) -> float:
        """Returns the smallest multiple of a step, 1 to MAX_STOPS, that is enough, or MAX_STOPS."""
        small, large = STEPS_PER_STOP, MAX_STOPS * STEPS_PER_STOP
        while small < large:
            middle = (small + large) // 2
            if is_enough(middle / STEPS_PER_STOP):
                large = middle
            else:
                small = middle + 1
        return large / STEPS_PER_STOP

    low = -search(lambda s: unseen(array("f", (MIDDLE_GRAY * 2 ** v if v >= -s else 0 for v in stops))))
    high = search(lambda s: unseen(light_of(array("d", (min(v, s) for v in stops)))))
    return low, high


def random_stops(count: int, low: float, high: float, seed: int) -> array:
    """Returns colors as stops, the same ones in each run: half of them with channels of their own, half of them near gray."""
    source = random.Random(seed)
    stops = array("d")
    for i in range(count):
        base = source.uniform(low, high)
        stops.extend(source.uniform(low, high) if i % 2 else min(max(base + source.uniform(-2, 2), low), high) for _ in range(3))
    return stops


def light_of(stops: array) -> array:
    """Returns the linear light of stops."""
    return array("f", (MIDDLE_GRAY * 2 ** v for v in stops))


def exact(processor, light: array, least: float = 0.0, most: float = 1.0) -> array:
    """Returns the values that a conversion gives, limited; NaN, which a logarithm may give for black, becomes 0.

    Raises:
        NoNumberError: NaN or infinity for a color without black channels
    """
    shown = array("f", light)
    processor.applyRGB(shown)
    if not all(map(math.isfinite, shown)):
        for i in range(0, len(shown), 3):
            if min(light[i:i + 3]) > 0 and not all(map(math.isfinite, shown[i:i + 3])):
                raise NoNumberError
    # Comparisons with NaN are false.
    return array("f", [v if least <= v <= most else most if v > most else least if v < least else 0.0 for v in shown])
