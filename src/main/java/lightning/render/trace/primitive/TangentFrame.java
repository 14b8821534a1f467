package lightning.render.trace.primitive;

import lightning.render.trace.mesh.TrianglePoint;

/**
 * Tangent frame of a normal map from a mesh's tangents: T along the tangent and perpendicular to the normal N; B = ±(N × T) by
 * the tangent's handedness. Reused.
 *
 * <p>Tangents are transformed to the scene like directions, by the transform itself. The primitive stores its inverse; with
 * rows a, b, c of the inverse, the transformed tangent is t₀·(b × c) + t₁·(c × a) + t₂·(a × b) up to a factor. If the transform
 * mirrors, N × T changes sides, and so does the image.
 */
final class TangentFrame {
    double tx;
    double ty;
    double tz;
    double bx;
    double by;
    double bz;

    /**
     * Computes the frame; returns false if there is none.
     *
     * @param m transform to the mesh's local space at {@code m[i …]}
     * @param nx outward normal, of length 1
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

    /** Returns one coordinate of the cross product of two rows. */
    static double cross(double[] m, int i, int a, int b, int j, int k) {
        return m[i + a + j] * m[i + b + k] - m[i + a + k] * m[i + b + j];
    }
}
