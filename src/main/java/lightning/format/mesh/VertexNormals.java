package lightning.format.mesh;

/** Normalization and computation of vertex normals. */
public final class VertexNormals {
    private VertexNormals() {}

    /**
     * Normalizes normals. Zero or NaN normals are replaced by the area-weighted mean of the adjacent triangles' normals or,
     * if that is zero, by z.
     *
     * @param normals {@code float[3 * vertices]}, of any length; modified
     * @param positions {@code float[3 * vertices]}
     * @param triangles three vertices each
     */
    public static void normalizeAll(float[] normals, float[] positions, int[] triangles) {
        boolean missing = false;
        for (int i = 0; i < normals.length; i += 3) {
            missing |= !normalize(normals, i, normals[i], normals[i + 1], normals[i + 2]);
        }
        if (missing) {
            double[] sums = areaWeightedSums(positions, triangles);
            for (int i = 0; i < normals.length; i += 3) {
                if (normals[i] == 0 && normals[i + 1] == 0 && normals[i + 2] == 0
                        && !normalize(normals, i, sums[i], sums[i + 1], sums[i + 2])) {
                    normals[i + 2] = 1;
                }
            }
        }
    }

    /** Returns the area-weighted means of the adjacent triangles' normals, {@code float[3 * vertices]}. */
    public static float[] smooth(float[] positions, int[] triangles) {
        float[] normals = new float[positions.length];
        normalizeAll(normals, positions, triangles);
        return normals;
    }

    /** Returns for each vertex the sum of the adjacent triangles' area vectors, times two, {@code double[3 * vertices]}. */
    private static double[] areaWeightedSums(float[] p, int[] triangles) {
        double[] sums = new double[p.length];
        for (int t = 0; t < triangles.length; t += 3) {
            int a = 3 * triangles[t];
            int b = 3 * triangles[t + 1];
            int c = 3 * triangles[t + 2];
            for (int axis = 0; axis < 3; axis++) {
                int y = (axis + 1) % 3;
                int z = (axis + 2) % 3;
                double area = ((double) p[b + y] - p[a + y]) * ((double) p[c + z] - p[a + z])
                        - ((double) p[b + z] - p[a + z]) * ((double) p[c + y] - p[a + y]);
                sums[a + axis] += area;
                sums[b + axis] += area;
                sums[c + axis] += area;
            }
        }
        return sums;
    }

    /** Writes a normalized direction; writes zero and returns false if it has no direction. */
    static boolean normalize(float[] out, int offset, double x, double y, double z) {
        double max = Math.max(Math.max(Math.abs(x), Math.abs(y)), Math.abs(z));
        boolean hasDirection = max > 0 && Double.isFinite(max);
        double length = Math.sqrt(x / max * (x / max) + y / max * (y / max) + z / max * (z / max));
        out[offset] = hasDirection ? (float) (x / max / length) : 0;
        out[offset + 1] = hasDirection ? (float) (y / max / length) : 0;
        out[offset + 2] = hasDirection ? (float) (z / max / length) : 0;
        return hasDirection;
    }
}
