# SPDX-License-Identifier: Apache-2.0
"""What a tree of shader nodes reflects, as a sum of lobes that a single Principled BSDF has too."""

from dataclasses import dataclass, field

WHITE = (1.0, 1.0, 1.0)
BLACK = (0.0, 0.0, 0.0)


@dataclass
class Lobes:
    """Colors and weights of a surface. A sum of several has the colors of all, and means of the rest."""

    diffuse: tuple = BLACK
    metal: tuple = BLACK
    transmitted: tuple = BLACK
    emitted: tuple = BLACK
    # Reflection of the nonmetal part at normal incidence.
    f0: tuple = BLACK
    opacity: float = 1.0
    # Means, by the weight of the reflections.
    roughness: float = 1.0
    index: float = 1.5
    coat: float = 0.0
    coat_roughness: float = 0.03
    coat_index: float = 1.5
    sheen: tuple = BLACK
    sheen_roughness: float = 0.5
    anisotropy: float = 0.0
    # Turns.
    anisotropy_rotation: float = 0.0
    # Sockets that give a color, a roughness, … by its socket of a Principled BSDF, with the weight of the shader that has it.
    links: dict = field(default_factory=dict)

    def shine(self) -> float:
        """Returns the weight of all that has a roughness."""
        return mean(self.metal) + mean(self.f0) + mean(self.transmitted)

    def body(self) -> tuple:
        """Returns the base color."""
        return tuple(min(sum(parts), 1.0) for parts in zip(self.diffuse, self.metal, self.transmitted))


def mean(color) -> float:
    """Returns the mean of a color."""
    return sum(color) / 3


def times(color, factor) -> tuple:
    """Returns a color multiplied by a number."""
    return tuple(c * factor for c in color)


def mix(a: Lobes, b: Lobes, factor: float) -> Lobes:
    """Returns a share of one surface and the rest of another.

    Args:
        factor: share of the second
    """
    return total(a, b, 1 - factor, factor)


def add(a: Lobes, b: Lobes) -> Lobes:
    """Returns the sum of two surfaces. Nothing reflects more than it gets, so a sum of more is a mean."""
    result = total(a, b, 1.0, 1.0)
    most = max(1.0, *(sum(parts) for parts in zip(result.diffuse, result.metal, result.transmitted)))
    result.diffuse, result.metal, result.transmitted = (times(color, 1 / most) for color in (result.diffuse, result.metal, result.transmitted))
    result.sheen = tuple(min(c, 1.0) for c in result.sheen)
    result.opacity, result.coat = min(1.0, a.opacity + b.opacity - 1 if min(a.opacity, b.opacity) < 1 else 1.0), min(1.0, result.coat)
    return result


def total(a: Lobes, b: Lobes, first: float, second: float) -> Lobes:
    """Returns the sum of two surfaces with weights."""
    def colors(name: str) -> tuple:
        return tuple(first * x + second * y for x, y in zip(getattr(a, name), getattr(b, name)))

    def average(name: str, x: float, y: float) -> float:
        weight = x + y
        return (x * getattr(a, name) + y * getattr(b, name)) / weight if weight > 0 else max(getattr(a, name), getattr(b, name))

    shines = first * a.shine(), second * b.shine()
    coats = first * a.coat, second * b.coat
    sheens = first * mean(a.sheen), second * mean(b.sheen)
    result = Lobes(*(colors(name) for name in ("diffuse", "metal", "transmitted", "emitted", "f0")), roughness=average("roughness", *shines),
                   index=average("index", first * mean(a.transmitted), second * mean(b.transmitted)), coat=sum(coats),
                   opacity=first * a.opacity + second * b.opacity, coat_roughness=average("coat_roughness", *coats), coat_index=average("coat_index", *coats),
                   sheen=colors("sheen"), sheen_roughness=average("sheen_roughness", *sheens), anisotropy=average("anisotropy", *shines),
                   anisotropy_rotation=(a if shines[0] * a.anisotropy >= shines[1] * b.anisotropy else b).anisotropy_rotation)
    for lobes, weight in ((a, first), (b, second)):
        for name, (socket, strength) in lobes.links.items():
            if weight * strength > result.links.get(name, (None, 0.0))[1]:
                result.links[name] = (socket, weight * strength)
    return result
