package lightning.render.trace;

import lightning.base.math.Vec3;

/**
 * Place of a ray's hit on its shape.
 *
 * @param point hit point, render space; not offset from the surface
 * @param local the same point in the coordinates of the shape
 * @param u horizontal texture coordinate, before the repeats of a material; 0 for a mesh without texture coordinates
 * @param v texture coordinate upward, as {@code u}
 */
public record SurfaceLocation(Vec3 point, Vec3 local, double u, double v) {}
