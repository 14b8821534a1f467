package lightning.render.trace.primitive;

import lightning.render.trace.mesh.TrianglePoint;

/**
 * The frame of a normal map that a mesh's tangents make: T along the tangent and at a right angle to the normal N, B = N × T, or its
 * opposite by the tangent's hand. Reused for one after the other.
 *
 * <p>Tangents go to the scene as directions do, by the map itself, of which a primitive has the inverse: up to a factor they are
 * t₀·(b × c) + t₁·(c × a) + t₂·(a × b), a, b, c being its rows. Where that map mirrors, N × T is on the other side, as the picture is.
 */
final class TangentFrame {
    double tx;
    double ty;
    double tz;
    double bx;
    double by;
    double bz;

    /**
     * Computes it; whether there is one.
     *
     * @param m  the map to the mesh's own space at {@code m[i …]}
     * @param nx the normal that points outwards, of length 1
     */
    boolean compute(TrianglePoint facet, double[] m, int i, double nx, double ny, double nz) {
        double t0 = facet.tangent(0);
        double t1 = facet.tangent(1);
        double t2 = facet.tangent(2);
        double x = t0 * cross(m, i, 4, 8, 1, 2) + t1 * cross(m, i, 8, 0, 1, 2) + t2 * cross(m, i, 0, 4, 1, 2);
        double y = t0 * cross(m, i, 4, 8, 2, 0) + t1 * cross(m, i, 8, 0, 2, 0) + t2 * cross(m, i, 0, 4, 2, 0);
        double z = t0 * cross(m, i, 4, 8, 0, 1) + t1 * cross(m, i, 8, 0, 0, 1) + t2 * cross(m, i, 0, 4, 0, 1);
        double volume = m[i] * cross(m, i, 4, 8, 1, 2) + m[i + 1] * cross(m, i, 4, 8, 2, 0) + m[i + 2] * cross(m, i, 4, 8, 0, 1);
        double along = x * nx + y * ny + z * nz;
        double side = volume < 0 ? -1 : 1;
        x = side * (x - along * nx);
        y = side * (y - along * ny);
        z = side * (z - along * nz);
        double unit = 1 / Math.sqrt(x * x + y * y + z * z);
        boolean valid = unit > 0 && unit < Double.POSITIVE_INFINITY;
        double handedness = facet.tangent(3) < 0 ? -side : side;
        tx = x * unit;
        ty = y * unit;
        tz = z * unit;
        bx = handedness * (ny * tz - nz * ty);
        by = handedness * (nz * tx - nx * tz);
        bz = handedness * (nx * ty - ny * tx);
        return valid;
    }

    /** One coordinate of the cross product of two rows. */
    private static double cross(double[] m, int i, int a, int b, int j, int k) {
        return m[i + a + j] * m[i + b + k] - m[i + a + k] * m[i + b + j];
    }
}
