package lightning.render.trace.primitive;

import lightning.render.trace.mesh.TrianglePoint;

/**
 * Smooth shading of a flat triangle: interpolated vertex normal, and a point lifted to the rounded surface. Reused.
 *
 * <p><b>Normal:</b> mean of the vertex normals with the barycentric weights, on the visible side of the triangle. Near
 * silhouettes, reflected rays could enter the surface, so it is {@link ShadingNormal#bend bent} afterward. Materials that do
 * not reflect get the same normal, so that editing a material never moves it.
 *
 * <p><b>Point:</b> start of shadow rays, lifted by the same weights to the planes through the vertices perpendicular to their
 * normals; planes below the point are skipped (Hanika 2021, Hacking the Shadow Terminator, Ray Tracing Gems II, chapter 4).
 * Otherwise a round body would show the shadows of its own facets near the terminator. Concave surfaces are not lifted, nor are
 * vertices whose normal points into the triangle. The lift of a vertex is at most the one that the mean normal of the facets around it
 * gives: a large facet beside a bevel stays flat, so that its points are not lifted into other objects.
 */
final class SmoothNormal {
    private final double[] x = new double[3];
    private final double[] y = new double[3];
    private final double[] z = new double[3];
    /** 1 if the vertex normals point to the visible side, −1 if they point away from it. */
    double side;
    /** Lift of the point, scene units. */
    double liftX;
    double liftY;
    double liftZ;

    /**
     * Computes the normal in scene space.
     *
     * @param m transform to the mesh's local space at {@code m[i …]}; its transpose transforms normals back
     * @param gx normal of the triangle, of length 1, on the visible side
     * @param result receives the normal, not yet bent
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

    /**
     * Computes the lift at the point whose normal was computed last.
     *
     * @param facetNormals those of {@link lightning.render.trace.mesh.MeshSolid#facetNormals}
     */
    void computeLift(TrianglePoint facet, float[] facetNormals, double gx, double gy, double gz) {
        liftX = 0;
        liftY = 0;
        liftZ = 0;
        for (int v = 0; v < 3; v++) {
            double square = x[v] * x[v] + y[v] * y[v] + z[v] * z[v];
            double below = Math.min(-side * facet.tangentPlaneDistance(v), -side * facet.planeDistance(v, facetNormals));
            if (below > 0 && side * (x[v] * gx + y[v] * gy + z[v] * gz) > 0) {
                // The side applies twice: to measure the plane's distance in the scene, and to move by it.
                double scale = side * facet.weight(v) * below / square;
                liftX += scale * x[v];
                liftY += scale * y[v];
                liftZ += scale * z[v];
            }
        }
    }
}
