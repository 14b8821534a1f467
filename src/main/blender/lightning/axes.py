# SPDX-License-Identifier: Apache-2.0
"""Axes: Blender has z up, Lightning and glTF have y up."""

import math

import numpy
from mathutils import Matrix, Vector

TO_LIGHTNING = Matrix(((1, 0, 0, 0), (0, 0, 1, 0), (0, -1, 0, 0), (0, 0, 0, 1)))
TO_BLENDER = TO_LIGHTNING.transposed()


def number(value: float) -> float:
    """Returns the shortest decimal number that is the same single-precision number, as Blender stores it."""
    return float(str(numpy.float32(value))) + 0.0


def vector(v) -> list[float]:
    """Returns a Blender vector in Lightning's axes."""
    return [number(v[0]), number(v[2]), number(-v[1])]


def blender_vector(v) -> Vector:
    """Returns a Lightning vector in Blender's axes."""
    return Vector((v[0], -v[2], v[1]))


def columns(matrix: Matrix) -> list[float]:
    """Returns a Blender transform in Lightning's axes, column by column as in glTF."""
    m = TO_LIGHTNING @ matrix @ TO_BLENDER
    return [m[row][column] for column in range(4) for row in range(4)]


def blender_matrix(values: list[float]) -> Matrix:
    """Returns a transform in Blender's axes of one in Lightning's, column by column."""
    return TO_BLENDER @ Matrix([values[i:i + 4] for i in range(0, 16, 4)]).transposed() @ TO_LIGHTNING


def lightning_rotation(rotation: Matrix) -> Matrix:
    """Returns a Blender rotation of three rows in Lightning's axes."""
    return TO_LIGHTNING.to_3x3() @ rotation @ TO_BLENDER.to_3x3()


def blender_rotation(rotation: Matrix) -> Matrix:
    """Returns a rotation of three rows in Blender's axes."""
    return TO_BLENDER.to_3x3() @ rotation @ TO_LIGHTNING.to_3x3()


def light_matrix(position, direction, up) -> Matrix:
    """Returns the Blender transform of a light that shines along `direction`; all arguments in Lightning's axes."""
    z = -blender_vector(direction).normalized()
    y = blender_vector(up)
    x = y.cross(z)
    if x.length < 1e-6 * max(y.length, 1e-30):
        x = Vector((0, 1, 0)).cross(z) if abs(z.y) < 0.9 else Vector((1, 0, 0))
    x.normalize()
    y = z.cross(x)
    m = Matrix((x, y, z)).transposed().to_4x4()
    m.translation = blender_vector(position)
    return m


def degrees(radians: float) -> float:
    """Returns degrees, rounded to the seven digits that Blender's floats have."""
    return float(f"{math.degrees(radians):.7g}")
