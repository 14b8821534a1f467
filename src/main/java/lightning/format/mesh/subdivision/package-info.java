/**
 * Subdivision surfaces (Catmull and Clark, Recursively generated B-spline surfaces on arbitrary topological meshes, 1978) with creases and
 * corners of any sharpness (DeRose, Kass and Truong, Subdivision surfaces in character animation, 1998).
 *
 * <pre>{@code
 * var cube = new ControlMesh(points, 3, counts, corners);
 * cube.setCrease(0, 1, 2.5f);
 * RefinedMesh quads = SubdivisionSurface.refine(cube, cornerValues, 2, 2);
 * }</pre>
 */
@NullMarked
package lightning.format.mesh.subdivision;

import org.jspecify.annotations.NullMarked;
