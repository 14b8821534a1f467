# SPDX-License-Identifier: Apache-2.0
"""Nodes of the glTF file: flat except for instances, which are below the object that makes them, so that they move with it."""

import numpy
from mathutils import Matrix, Quaternion, Vector

# A camera of glTF looks along -z, y up.
CAMERA_TURN = Quaternion((2 ** 0.5 / 2, -2 ** 0.5 / 2, 0.0, 0.0)).to_matrix().to_4x4()
# Cosine of the angle between two axes from which on a matrix shears, and the determinant below which it has no inverse.
SHEAR = 1e-5
FLAT = 1e-12


def of_snapshot(snapshot, meshes: dict[int, int], entries: list[dict]) -> tuple[list[dict], list[int]]:
    """Returns the nodes of what a render shows, and the indices of those that are below no other.

    Args:
        meshes: index in the file of each mesh of the snapshot that the file has
        entries: the first nodes
    """
    result = _Nodes(entries)
    # A name belongs to the first node that has it. So objects come before instances of them.
    for name, shown in sorted(snapshot.objects.items(), key=lambda item: bool(item[1].children)):
        shapes = [shape for shape in shown.shapes if shape in meshes]
        children = [child for child in shown.children if child[2] in meshes]
        if len(shapes) == 1 and not children:
            result.add_root(name, shown.matrix, {"mesh": meshes[shapes[0]]})
        elif shapes or children:
            is_flat = abs(shown.matrix.determinant()) < FLAT
            own, inverse = (shown.matrix, Matrix()) if is_flat else (Matrix(), shown.matrix.inverted())
            parts = [(f"{name} {snapshot.shapes[shape].part}", own, shape) for shape in shapes]
            parts += [(instance_name(child, snapshot.objects), inverse @ matrix, shape) for child, matrix, shape in children]
            below = [result.add(part, matrix, {"mesh": meshes[shape]}) for part, matrix, shape in parts]
            result.add_root(name, Matrix() if is_flat else shown.matrix, {"children": below})
    for name, matrix, shape in snapshot.loose:
        if shape in meshes:
            result.add_root(instance_name(name, snapshot.objects), matrix, {"mesh": meshes[shape]})
    return result.entries, result.roots


class _Nodes:
    """List of nodes that grows."""

    def __init__(self, entries: list[dict]) -> None:
        self.entries = list(entries)
        self.roots = list(range(len(entries)))

    def add_root(self, name: str, matrix: Matrix, content: dict) -> None:
        self.roots.append(self.add(name, matrix, content))

    def add(self, name: str, matrix: Matrix, content: dict) -> int:
        """Adds a node, returns its index."""
        if is_sheared(matrix):
            # glTF has no shear: a node with another rotation is below one with a scale.
            left, scale, right = numpy.linalg.svd(numpy.array(matrix.to_3x3(), dtype=numpy.float64))
            if numpy.linalg.det(left) < 0:
                left[:, 2], scale[2] = -left[:, 2], -scale[2]
            if numpy.linalg.det(right) < 0:
                right[2], scale[2] = -right[2], -scale[2]
            content = {"children": [self.add(f"{name} turned", Matrix(right.tolist()).to_4x4(), content)]}
            matrix = Matrix.Translation(matrix.translation) @ Matrix((left * scale).tolist()).to_4x4()
        self.entries.append({"name": name} | placement(matrix) | content)
        return len(self.entries) - 1


def instance_name(name: str, taken) -> str:
    """Returns the name of an instance, which is not one of the scene's objects."""
    return f"{name} instance" if name in taken else name


def is_sheared(matrix: Matrix) -> bool:
    """Returns whether a matrix is no product of a translation, a rotation and a scale."""
    x, y, z = (matrix.col[i].to_3d() for i in range(3))
    return any(abs(a.dot(b)) > SHEAR * a.length * b.length for a, b in ((x, y), (y, z), (z, x)))


def placement(matrix: Matrix) -> dict:
    """Returns the transform of a node: y is up."""
    place, rotation, scale = matrix.decompose()
    rotation.normalize()
    place = _rounded(Vector((place[0], place[2], -place[1])), (0, 0, 0))
    rotation = _rounded(Quaternion((rotation[0], rotation[1], rotation[3], -rotation[2])), (1, 0, 0, 0))
    scale = _rounded(Vector((scale[0], scale[2], scale[1])), (1, 1, 1))
    result = {}
    if place != [0, 0, 0]:
        result["translation"] = place
    if rotation != [1, 0, 0, 0]:
        result["rotation"] = [*rotation[1:], rotation[0]]
    if scale != [1, 1, 1]:
        result["scale"] = scale
    return result


def of_object(obj) -> dict:
    """Returns the transform of an object's node."""
    return placement(obj.matrix_world @ CAMERA_TURN if obj.type == "CAMERA" else obj.matrix_world)


def _rounded(values, targets: tuple) -> list[float]:
    # Single precision leaves components that are close to those of no transform.
    for i, target in enumerate(targets):
        values[i] = values[i] if abs(values[i] - target) > 2.0e-6 else target
    return list(values)
