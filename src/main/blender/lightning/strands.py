# SPDX-License-Identifier: Apache-2.0
"""Hair as tubes of three sides: Lightning has no curves."""

import bpy
import numpy

# Most points of the hair of one object. Of more, only some strands are sent, and these are thicker.
MOST_POINTS = 200_000
SIDES = 3
# A tube of three sides is as wide from the side, on average, as a round one if its corners are that much farther out.
CORNER = 2 * numpy.pi / (2 * SIDES * numpy.sin(numpy.pi / SIDES))
# Radius of hair curves that have none, in meters.
RADIUS = 0.005


def of_curves(curves, name: str, left_out):
    """Returns a mesh of evaluated hair curves; None if there are none."""
    offsets = numpy.empty(len(curves.curve_offset_data), dtype=numpy.int32)
    curves.curve_offset_data.foreach_get("value", offsets)
    points = numpy.empty(3 * len(curves.points), dtype=numpy.float32)
    curves.position_data.foreach_get("vector", points)
    radii = numpy.full(len(curves.points), RADIUS, dtype=numpy.float32)
    attribute = curves.attributes.get("radius")
    if attribute is not None and attribute.domain == "POINT" and attribute.data_type == "FLOAT":
        attribute.data.foreach_get("value", radii)
    points = points.reshape(-1, 3)
    step = _step(len(points), len(offsets) - 1, name, left_out)
    kept = range(0, len(offsets) - 1, step)
    strands = [(points[offsets[i]:offsets[i + 1]], radii[offsets[i]:offsets[i + 1]] * step) for i in kept]
    return _mesh(name, strands)


def of_particles(obj, system, left_out):
    """Returns a mesh of a hair system of an evaluated object, in the object's space; None if it has no hair."""
    settings = system.settings
    parents, children = len(system.particles), len(system.child_particles)
    first = parents if settings.child_type != "NONE" and children else 0
    count = parents + children - first
    steps = 2 ** settings.render_step + 1
    step = _step(count * steps, count, obj.original.name, left_out)
    inverse = numpy.array(obj.matrix_world.inverted_safe(), dtype=numpy.float64)
    share = numpy.linspace(0, 1, steps)
    thickness = (1 - share) ** (1 + settings.shape if settings.shape < 0 else 1 / (1 - settings.shape) if settings.shape < 1 else 1e6)
    thickness[0] = 1
    radii = (settings.tip_radius + (settings.root_radius - settings.tip_radius) * thickness) * settings.radius_scale / 2
    if settings.use_close_tip:
        radii[-1] = 0
    strands = []
    for number in range(first, first + count, step):
        points = numpy.array([system.co_hair(object=obj, particle_no=number, step=i) for i in range(steps)], dtype=numpy.float64)
        strands.append((points @ inverse[:3, :3].T + inverse[:3, 3], radii * step))
    return _mesh(obj.original.name, strands)


def _step(points: int, strands: int, name: str, left_out) -> int:
    """Returns which strands are sent: each one, each second one and so on."""
    step = -(-points // MOST_POINTS) if points else 1
    if step > 1:
        left_out.add(f"too many points of hair, so only one of {step} strands is sent, {step} times as thick", f"{name} ({strands} strands)")
    return step


def _mesh(name: str, strands: list):
    """Returns a mesh of tubes; each has the points of its axis and their radii."""
    strands = [(points[is_new], radii[is_new]) for points, radii in strands for is_new in [_is_new(points)] if is_new.sum() > 1]
    if not strands:
        return None
    lengths = numpy.array([len(points) for points, _ in strands])
    ends = numpy.cumsum(lengths)
    starts = ends - lengths
    points = numpy.concatenate([p for p, _ in strands]).astype(numpy.float64)
    radii = numpy.concatenate([r for _, r in strands]) * CORNER
    before, after = numpy.arange(len(points)) - 1, numpy.arange(len(points)) + 1
    before[starts], after[ends - 1] = starts, ends - 1
    tangents = points[after] - points[before]
    tangents /= numpy.maximum(numpy.linalg.norm(tangents, axis=1, keepdims=True), 1e-30)
    # All points of a strand turn about the axis to which its chord is most perpendicular.
    axis = numpy.eye(3)[numpy.argmin(numpy.abs(points[ends - 1] - points[starts]), axis=1)]
    normals = numpy.cross(tangents, numpy.repeat(axis, lengths, axis=0))
    normals /= numpy.maximum(numpy.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
    others = numpy.cross(tangents, normals)
    angles = 2 * numpy.pi * numpy.arange(SIDES) / SIDES
    ring = normals[:, None] * numpy.cos(angles)[:, None] + others[:, None] * numpy.sin(angles)[:, None]
    corners = (points[:, None] + radii[:, None, None] * ring).reshape(-1, 3)
    segments = numpy.setdiff1d(numpy.arange(len(points)), ends - 1)[:, None] * SIDES
    side, following = numpy.arange(SIDES), (numpy.arange(SIDES) + 1) % SIDES
    faces = numpy.stack([segments + side, segments + following, segments + SIDES + following, segments + SIDES + side], axis=2).reshape(-1)
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(len(corners))
    mesh.vertices.foreach_set("co", corners.astype(numpy.float32).reshape(-1))
    mesh.loops.add(len(faces))
    mesh.loops.foreach_set("vertex_index", faces.astype(numpy.int32))
    mesh.polygons.add(len(faces) // 4)
    mesh.polygons.foreach_set("loop_start", numpy.arange(0, len(faces), 4, dtype=numpy.int32))
    mesh.update(calc_edges=True)
    mesh.shade_smooth()
    return mesh


def _is_new(points):
    """Returns which points are elsewhere than the one before."""
    return numpy.concatenate([[True], (numpy.diff(points, axis=0) != 0).any(axis=1)])
