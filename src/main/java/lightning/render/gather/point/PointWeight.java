package lightning.render.gather.point;

import lightning.render.gather.cell.SurfaceColumns;

/**
 * Weight of a gather point at a place on a surface, after E. Tabellion and A. Lamorlette, An approximate global illumination system for
 * computer generated films, 2004: it falls with the distance, with the angle between the normals, and with the distance from the tangent
 * plane, and the largest of the three counts.
 */
public final class PointWeight {
    /** Smallest cosine between the normals: 32°. */
    private static final float MIN_COSINE = 0.85f;
    private static final float COSINE_SCALE = 1 / (1 - MIN_COSINE);
    /**
     * Distance from the tangent plane at which a point is not valid, relative to its radius: on flat surfaces, where only a step can cause it,
     * more for other normals, and at most. The plane has the mean of both normals, so a curved surface stays near it.
     */
    private static final float FLAT_PLANE = 0.1f;
    private static final float PLANE_PER_ANGLE = 0.3f;
    private static final float MAX_PLANE = 0.3f;
    /** Factor of the distance to a point behind a barrier: it counts only if there are no others. */
    private static final float BEHIND_BARRIER = 1e6f;
    /** Smallest cosine between normals, and largest distance from the plane in radii, of points on one plane. */
    private static final float SAME_NORMAL = 0.9999f;
    private static final float SAME_PLANE = 0.01f;
    /** Weight of an angle in the distance to the nearest point where none is valid. */
    private static final float ANGLE = 40;

    private PointWeight() {}

    /**
     * Returns the weight of a point in the mean that a surface takes, 0…1: smooth where a point begins to count.
     *
     * @param p      gather point
     * @param radius distance at which it is 0, scene units
     */
    public static float at(SurfaceColumns points, int p, float radius, float x, float y, float z, float nx, float ny, float nz) {
        float weight = flat(points, p, radius, x, y, z, nx, ny, nz);
        return weight * weight;
    }

    /** Returns the weight of a point in the mean that removes noise, 0…1: more equal weights leave less noise. Parameters as above. */
    public static float flat(SurfaceColumns points, int p, float radius, float x, float y, float z, float nx, float ny, float nz) {
        float dx = x - points.px[p];
        float dy = y - points.py[p];
        float dz = z - points.pz[p];
        float square = dx * dx + dy * dy + dz * dz;
        if (!(square < radius * radius)) {
            return 0;
        }
        float cosine = nx * points.nx[p] + ny * points.ny[p] + nz * points.nz[p];
        if (!(cosine > MIN_COSINE)) {
            return 0;
        }
        float plane = Math.abs(dx * (points.nx[p] + nx) + dy * (points.ny[p] + ny) + dz * (points.nz[p] + nz)) * 0.5f;
        float angle = (float) Math.sqrt(Math.max(0, (1 - cosine) * COSINE_SCALE));
        float validPlane = Math.min(MAX_PLANE, FLAT_PLANE + PLANE_PER_ANGLE * angle);
        float worst = Math.max(Math.max((float) Math.sqrt(square) / radius, angle), plane / (validPlane * radius));
        return worst < 1 ? 1 - worst : 0;
    }

    /**
     * Returns whether two points lie on one plane.
     *
     * @param radius of the first, scene units
     */
    public static boolean areOnOnePlane(SurfaceColumns points, int p, int q, float radius) {
        float cosine = points.nx[p] * points.nx[q] + points.ny[p] * points.ny[q] + points.nz[p] * points.nz[q];
        float height = (points.px[q] - points.px[p]) * points.nx[p] + (points.py[q] - points.py[p]) * points.ny[p]
                + (points.pz[q] - points.pz[p]) * points.nz[p];
        return cosine > SAME_NORMAL && Math.abs(height) < SAME_PLANE * radius;
    }

    /** Returns {@link #distance} of a point, made much larger if a barrier separates it from the place. */
    public static float distance(SurfaceColumns points, int p, Barriers barriers, float x, float y, float z, float nx, float ny, float nz) {
        return distance(points, p, x, y, z, nx, ny, nz) * (barriers.separate(points, p, x, y, z) ? BEHIND_BARRIER : 1);
    }

    /** Returns a measure by which the nearest point is chosen where none is valid: the square of the distance, more for other normals. */
    public static float distance(SurfaceColumns points, int p, float x, float y, float z, float nx, float ny, float nz) {
        float dx = x - points.px[p];
        float dy = y - points.py[p];
        float dz = z - points.pz[p];
        float cosine = nx * points.nx[p] + ny * points.ny[p] + nz * points.nz[p];
        return (dx * dx + dy * dy + dz * dz) * (1 + ANGLE * Math.max(0, 1 - cosine));
    }
}
