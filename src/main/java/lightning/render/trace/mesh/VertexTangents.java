package lightning.render.trace.mesh;

import static java.util.Objects.requireNonNull;

import java.util.HashMap;
import java.util.Map;
import lightning.scene.node.Mesh;

/**
 * Tangents of the vertices of a mesh: means of the directions in which u grows over the triangles around them, weighted by their angles there. At a seam of the
 * texture, vertices of the same place and normal take part in each other's mean if their directions are similar.
 */
final class VertexTangents {
    /** Smallest cosine between the directions on both sides of a seam that counts as none. */
    private static final double SIMILAR = 0.5;
    /** Steps in which places differ, along the largest side of the box, and normals, per unit. */
    private static final double PLACES = 1e6;
    private static final double NORMALS = 1e4;

    private VertexTangents() {}

    /**
     * Returns x, y and z of each vertex's tangent, of length 1, or 0 for none. The mesh must have texture coordinates and normals.
     *
     * @param size largest side of the mesh's box
     */
    static float[] of(Mesh mesh, double size) {
        double[] sum = sums(mesh);
        int[] next = nextAtSamePlace(mesh, size);
        float[] tangents = new float[sum.length];
        double[] mean = new double[3];
        for (int v = 0; 3 * v < tangents.length; v++) {
            double own = length(sum, v);
            System.arraycopy(sum, 3 * v, mean, 0, 3);
            for (int w = next[v]; w != v; w = next[w]) {
                double along = sum[3 * v] * sum[3 * w] + sum[3 * v + 1] * sum[3 * w + 1] + sum[3 * v + 2] * sum[3 * w + 2];
                for (int axis = 0; axis < 3 && along > SIMILAR * own * length(sum, w); axis++) {
                    mean[axis] += sum[3 * w + axis];
                }
            }
            double length = length(mean, 0);
            for (int axis = 0; axis < 3 && length > 0 && length < Double.POSITIVE_INFINITY; axis++) {
                tangents[3 * v + axis] = (float) (mean[axis] / length);
            }
        }
        return tangents;
    }

    private static double length(double[] v, int i) {
        return Math.sqrt(v[3 * i] * v[3 * i] + v[3 * i + 1] * v[3 * i + 1] + v[3 * i + 2] * v[3 * i + 2]);
    }

    /** Returns for each vertex the sum of the directions of the triangles around it. */
    private static double[] sums(Mesh mesh) {
        double[] sum = new double[mesh.positions().length];
        double[] t = new double[3];
        int[] vertices = mesh.triangles();
        for (int i = 0; i < vertices.length; i++) {
            int a = vertices[i];
            int b = vertices[i % 3 == 2 ? i - 2 : i + 1];
            int c = vertices[i % 3 == 0 ? i + 2 : i - 1];
            writeGrowthOfU(mesh, a, b, c, t);
            double angle = angle(mesh.positions(), a, b, c);
            for (int axis = 0; axis < 3; axis++) {
                sum[3 * a + axis] += angle * t[axis];
            }
        }
        return sum;
    }

    /** Returns the angle of a triangle at vertex {@code a}, radians. */
    private static double angle(float[] p, int a, int b, int c) {
        double ex = (double) p[3 * b] - p[3 * a];
        double ey = (double) p[3 * b + 1] - p[3 * a + 1];
        double ez = (double) p[3 * b + 2] - p[3 * a + 2];
        double fx = (double) p[3 * c] - p[3 * a];
        double fy = (double) p[3 * c + 1] - p[3 * a + 1];
        double fz = (double) p[3 * c + 2] - p[3 * a + 2];
        double x = ey * fz - ez * fy;
        double y = ez * fx - ex * fz;
        double z = ex * fy - ey * fx;
        return StrictMath.atan2(Math.sqrt(x * x + y * y + z * z), ex * fx + ey * fy + ez * fz);
    }

    /**
     * Returns rings of the vertices of the same place and normal, apart from roundings in a file: for each vertex the next one, or itself.
     *
     * @param size largest side of the mesh's box
     */
    private static int[] nextAtSamePlace(Mesh mesh, double size) {
        record Place(int x, int y, int z, int nx, int ny, int nz) {}
        float[] p = mesh.positions();
        float[] n = requireNonNull(mesh.normals());
        double scale = PLACES / size;
        int[] next = new int[p.length / 3];
        Map<Place, Integer> first = HashMap.newHashMap(next.length);
        for (int v = 0; v < next.length; v++) {
            Integer other = first.putIfAbsent(new Place(step(p[3 * v], scale), step(p[3 * v + 1], scale), step(p[3 * v + 2], scale),
                    step(n[3 * v], NORMALS), step(n[3 * v + 1], NORMALS), step(n[3 * v + 2], NORMALS)), v);
            next[v] = other == null ? v : next[other];
            if (other != null) {
                next[other] = v;
            }
        }
        return next;
    }

    private static int step(float value, double scale) {
        return (int) Math.round(value * scale);
    }

    /**
     * Writes the unit direction in which u grows over a triangle while v stays; 0 if its texture coordinates span no area.
     */
    static void writeGrowthOfU(Mesh mesh, int a, int b, int c, double[] to) {
        float[] p = mesh.positions();
        float[] uv = requireNonNull(mesh.coordinates());
        double ex = (double) p[3 * b] - p[3 * a];
        double ey = (double) p[3 * b + 1] - p[3 * a + 1];
        double ez = (double) p[3 * b + 2] - p[3 * a + 2];
        double fx = (double) p[3 * c] - p[3 * a];
        double fy = (double) p[3 * c + 1] - p[3 * a + 1];
        double fz = (double) p[3 * c + 2] - p[3 * a + 2];
        double eu = (double) uv[2 * b] - uv[2 * a];
        double ev = (double) uv[2 * b + 1] - uv[2 * a + 1];
        double fu = (double) uv[2 * c] - uv[2 * a];
        double fv = (double) uv[2 * c + 1] - uv[2 * a + 1];
        double side = Math.signum(eu * fv - fu * ev);
        double x = side * (fv * ex - ev * fx);
        double y = side * (fv * ey - ev * fy);
        double z = side * (fv * ez - ev * fz);
        double length = Math.sqrt(x * x + y * y + z * z);
        boolean exists = length > 0 && length < Double.POSITIVE_INFINITY;
        to[0] = exists ? x / length : 0;
        to[1] = exists ? y / length : 0;
        to[2] = exists ? z / length : 0;
    }
}
