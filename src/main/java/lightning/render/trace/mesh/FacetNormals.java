package lightning.render.trace.mesh;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.scene.node.Mesh;

/**
 * Means of the normals of the facets around each vertex, weighted by their areas. Where a large facet meets narrow ones, as at a beveled
 * edge, they are nearly those of the large facet, while vertex normals often lean by half of the first narrow facet's angle: the surface
 * that such normals describe would bulge far above the facet. Vertices of the same place and normal share their facets.
 */
final class FacetNormals {
    /** Smallest cosine between the normals of facets that lie on one plane. */
    private static final double ONE_PLANE = 1 - 0x1p-20;

    private FacetNormals() {}

    /**
     * Returns x, y and z of each vertex's mean, on the side of its normal and of about length 1. It is the vertex's normal if all facets around the vertex
     * are on one plane: they tell nothing of the surface that they approximate. The mesh must have normals.
     */
    static float[] of(Mesh mesh) {
        float[] normals = requireNonNull(mesh.normals());
        int[] first = firstAtSamePlace(mesh.positions(), normals);
        double[] sum = new double[normals.length];
        double[] areas = new double[first.length];
        double[] area = new double[3];
        int[] triangles = mesh.triangles();
        for (int i = 0; i < triangles.length; i++) {
            if (i % 3 == 0) {
                writeArea(mesh.positions(), triangles, i, area);
            }
            int v = first[triangles[i]];
            double side = Math.signum(area[0] * normals[3 * v] + area[1] * normals[3 * v + 1] + area[2] * normals[3 * v + 2]);
            for (int axis = 0; axis < 3; axis++) {
                sum[3 * v + axis] += side * area[axis];
            }
            areas[v] += side == 0 ? 0 : length(area, 0);
        }
        float[] means = normals.clone();
        for (int v = 0; v < first.length; v++) {
            int f = first[v];
            double length = length(sum, 3 * f);
            for (int axis = 0; axis < 3 && length > 0 && length < ONE_PLANE * areas[f]; axis++) {
                means[3 * v + axis] = (float) (sum[3 * f + axis] / length);
            }
        }
        return means;
    }

    private static double length(double[] v, int i) {
        return Math.sqrt(v[i] * v[i] + v[i + 1] * v[i + 1] + v[i + 2] * v[i + 2]);
    }

    /** Writes twice the area of the triangle whose vertices begin at element {@code i}, times its normal. */
    private static void writeArea(float[] p, int[] triangles, int i, double[] to) {
        int a = 3 * triangles[i];
        int b = 3 * triangles[i + 1];
        int c = 3 * triangles[i + 2];
        double ex = (double) p[b] - p[a];
        double ey = (double) p[b + 1] - p[a + 1];
        double ez = (double) p[b + 2] - p[a + 2];
        double fx = (double) p[c] - p[a];
        double fy = (double) p[c + 1] - p[a + 1];
        double fz = (double) p[c + 2] - p[a + 2];
        to[0] = ey * fz - ez * fy;
        to[1] = ez * fx - ex * fz;
        to[2] = ex * fy - ey * fx;
    }

    /** Returns for each vertex the first one of the same place and normal. */
    private static int[] firstAtSamePlace(float[] positions, float[] normals) {
        int[] first = new int[positions.length / 3];
        int mask = Integer.highestOneBit(Math.max(1, first.length)) * 4 - 1;
        int[] table = new int[mask + 1];
        Arrays.fill(table, -1);
        for (int v = 0; v < first.length; v++) {
            int hash = 0;
            for (int i = 3 * v; i < 3 * v + 3; i++) {
                hash = 31 * (31 * hash + Float.floatToIntBits(positions[i])) + Float.floatToIntBits(normals[i]);
            }
            int slot = (hash ^ hash >>> 15) * 0x9e3779b9 >>> 3 & mask;
            while (table[slot] >= 0 && !(areSame(positions, table[slot], v) && areSame(normals, table[slot], v))) {
                slot = slot + 1 & mask;
            }
            table[slot] = table[slot] < 0 ? v : table[slot];
            first[v] = table[slot];
        }
        return first;
    }

    private static boolean areSame(float[] values, int v, int w) {
        return Arrays.equals(values, 3 * v, 3 * v + 3, values, 3 * w, 3 * w + 3);
    }
}
