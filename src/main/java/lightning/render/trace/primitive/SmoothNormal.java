package lightning.render.trace.primitive;

import lightning.render.trace.mesh.TrianglePoint;

/**
 * How a flat triangle is shaded as a part of a smooth surface: by a normal between those of its vertices, from a point on a rounder
 * surface. Reused for one after the other.
 *
 * <p><b>The normal</b> is the mean of the vertices' by their weights at the point, on the side of the triangle that is seen. A mirror
 * would send some rays into the surface by it, at the rim of what is seen; it is therefore {@link ShadingNormal#bend bent} afterwards.
 * What the material does not mirror gets the same normal: a material's edit must not move it.
 *
 * <p><b>The point</b> from which shadows are asked is lifted to where the planes through the vertices at a right angle to their
 * normals are, those below it left out, by the same weights (Hanika 2021, Hacking the Shadow Terminator, Ray Tracing Gems II,
 * chapter 4). Else a round body would throw the shadow of its facets on itself where the light begins to set. Nothing is lifted where
 * the surface is hollow, nor from a vertex whose normal leads into the triangle.
 */
final class SmoothNormal {
    private final double[] x = new double[3];
    private final double[] y = new double[3];
    private final double[] z = new double[3];
    /** 1 where the vertices' normals lead to the side that is seen, −1 where they lead away from it. */
    double side;
    /** How the point is lifted, scene units. */
    double liftX;
    double liftY;
    double liftZ;

    /**
     * Computes the normal, in the scene.
     *
     * @param m  the map to the mesh's own space at {@code m[i …]}, by whose transpose normals come back
     * @param gx the triangle's normal, of length 1, on the side that is seen
     * @param result gets the normal, not yet bent
     */
    void compute(TrianglePoint facet, double[] m, int i, double gx, double gy, double gz, ShadingNormal result) {
        double sumX = 0;
        double sumY = 0;
        double sumZ = 0;
        for (int v = 0; v < 3; v++) {
            double ax = facet.normal(v, 0);
            double ay = facet.normal(v, 1);
            double az = facet.normal(v, 2);
            x[v] = m[i] * ax + m[i + 4] * ay + m[i + 8] * az;
            y[v] = m[i + 1] * ax + m[i + 5] * ay + m[i + 9] * az;
            z[v] = m[i + 2] * ax + m[i + 6] * ay + m[i + 10] * az;
            sumX += facet.weight(v) * x[v];
            sumY += facet.weight(v) * y[v];
            sumZ += facet.weight(v) * z[v];
        }
        side = sumX * gx + sumY * gy + sumZ * gz < 0 ? -1 : 1;
        if (!result.setNormalized(side * sumX, side * sumY, side * sumZ)) {
            result.setNormalized(gx, gy, gz);
        }
    }

    /** Computes the lift at the point whose normal was computed last. */
    void computeLift(TrianglePoint facet, double gx, double gy, double gz) {
        liftX = 0;
        liftY = 0;
        liftZ = 0;
        for (int v = 0; v < 3; v++) {
            double square = x[v] * x[v] + y[v] * y[v] + z[v] * z[v];
            double below = -side * facet.tangentPlaneDistance(v);
            if (below > 0 && side * (x[v] * gx + y[v] * gy + z[v] * gz) > 0) {
                // Once to measure the plane's distance in the scene, once to walk it.
                double scale = side * facet.weight(v) * below / square;
                liftX += scale * x[v];
                liftY += scale * y[v];
                liftZ += scale * z[v];
            }
        }
    }
}
