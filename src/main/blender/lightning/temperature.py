# SPDX-License-Identifier: Apache-2.0
"""Color temperatures: both programs keep the luminance of white, but Lightning's tint is relative to 6500 K."""

import functools

import bpy

NEUTRAL = 6500.0
LOWEST = 1667.0
HIGHEST = 25000.0


def _color(kelvin: float) -> list[float]:
    """Returns linear sRGB of a black body, by the cubic fit of the Planckian locus that Lightning uses."""
    t = kelvin
    if t <= 4000:
        x = ((-0.2661239e9 / t - 0.2343589e6) / t + 0.8776956e3) / t + 0.179910
    else:
        x = ((-3.0258469e9 / t + 2.1070379e6) / t + 0.2226347e3) / t + 0.240390
    if t <= 2222:
        y = ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
    elif t <= 4000:
        y = ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867
    else:
        y = ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483
    cie_x = x / y
    cie_z = (1 - x - y) / y
    return [max(c, 0.0) for c in (3.2406 * cie_x - 1.5372 - 0.4986 * cie_z,
                                  -0.9689 * cie_x + 1.8758 + 0.0415 * cie_z,
                                  0.0557 * cie_x - 0.2040 + 1.0570 * cie_z)]


def tint(kelvin: float) -> list[float]:
    """Returns the factors that Lightning multiplies a light's color by."""
    if kelvin == NEUTRAL:
        return [1.0, 1.0, 1.0]
    white = _color(NEUTRAL)
    relative = [c / w for c, w in zip(_color(kelvin), white)]
    luminance = 0.2126 * relative[0] + 0.7152 * relative[1] + 0.0722 * relative[2]
    return [c / luminance for c in relative]


@functools.lru_cache(maxsize=4096)
def black_body(kelvin: float) -> tuple[float, ...]:
    """Returns Blender's color of a temperature: of a light, and of a Blackbody node."""
    light = bpy.data.lights.new("lightning black body", "POINT")
    light.use_temperature, light.temperature = True, kelvin
    color = tuple(light.temperature_color)
    bpy.data.lights.remove(light)
    return color


def in_lightning(kelvin: float) -> tuple[float, list[float]]:
    """Returns the nearest temperature in Lightning, and the factors by which a color there differs from the color in Blender."""
    nearest = min(max(kelvin, LOWEST), HIGHEST)
    return nearest, [b / t if t > 0 else 1.0 for b, t in zip(black_body(kelvin), tint(nearest))]
