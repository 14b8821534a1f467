package lightning.render.gather.reflection;

import lightning.render.gather.cell.SurfaceColumns;

/** Weight of a reflection point at a place on a surface of the same material. */
public final class ReflectionWeight {
    /** Largest angle between mirrored views, in widths of the cells of directions. */
    private static final float ANGLE = 1.5f;
    /** Distance from the tangent plane at which a point is not valid, relative to its radius. */
    private static final float PLANE = 0.3f;
    /** Difference of roughness at which a point is not valid: a map of roughness stays sharp. */
    private static final float ROUGHNESS = 0.15f;

    private ReflectionWeight() {}

    /**
     * Returns the weight, 0…1; smooth where a point begins to count.
     *
     * @param p      point
     * @param g      its group
     * @param radius distance at which it is 0, scene units
     * @param rx     mirrored view at the place, as {@code ry} and {@code rz}
     * @param roughness of the surface there, with its map
     */
    public static float at(ReflectionGroup g, int p, float radius, float x, float y, float z, float nx, float ny, float nz, float rx,
            float ry,
            float rz, float roughness) {
        SurfaceColumns s = g.surface;
        float dx = x - s.px[p];
        float dy = y - s.py[p];
        float dz = z - s.pz[p];
        float square = dx * dx + dy * dy + dz * dz;
        if (!(square < radius * radius)) {
            return 0;
        }
        float ax = rx - g.rx[p];
        float ay = ry - g.ry[p];
        float az = rz - g.rz[p];
        float angle = (float) Math.sqrt(ax * ax + ay * ay + az * az) / (ANGLE * g.step);
        float plane = Math.abs(dx * (s.nx[p] + nx) + dy * (s.ny[p] + ny) + dz * (s.nz[p] + nz)) * 0.5f / (PLANE * radius);
        float blur = Math.abs(roughness - g.roughness[p]) / ROUGHNESS;
        float worst = Math.max(Math.max((float) Math.sqrt(square) / radius, angle), Math.max(plane, blur));
        float weight = worst < 1 ? 1 - worst : 0;
        return weight * weight;
    }
}
