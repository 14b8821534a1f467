package lightning.render.trace.mesh;

import static java.util.Objects.requireNonNull;

import lightning.scene.node.Mesh;

/** Tangents of the vertices of a mesh: means of the directions in which u grows over the triangles around them, weighted by area. */
final class VertexTangents {
    private VertexTangents() {}

    /** Returns x, y and z of each vertex's tangent, of length 1, or 0 for none. The mesh must have texture coordinates. */
    static float[] of(Mesh mesh) {
        float[] p = mesh.positions();
        double[] sum = new double[p.length];
        double[] t = new double[3];
        int[] vertices = mesh.triangles();
        for (int i = 0; i < vertices.length; i += 3) {
            int a = vertices[i];
            int b = vertices[i + 1];
            int c = vertices[i + 2];
            double area = writeGrowthOfU(mesh, a, b, c, t);
            for (int axis = 0; axis < 3; axis++) {
                sum[3 * a + axis] += area * t[axis];
                sum[3 * b + axis] += area * t[axis];
                sum[3 * c + axis] += area * t[axis];
            }
        }
        float[] tangents = new float[p.length];
        for (int v = 0; v < tangents.length; v += 3) {
            double length = Math.sqrt(sum[v] * sum[v] + sum[v + 1] * sum[v + 1] + sum[v + 2] * sum[v + 2]);
            if (length > 0 && length < Double.POSITIVE_INFINITY) {
                for (int axis = 0; axis < 3; axis++) {
                    tangents[v + axis] = (float) (sum[v + axis] / length);
                }
            }
        }
        return tangents;
    }

    /**
     * Writes the unit direction in which u grows over a triangle while v stays; 0 if its texture coordinates span no area. Returns twice the area
     * of the triangle.
     */
    static double writeGrowthOfU(Mesh mesh, int a, int b, int c, double[] to) {
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
        double nx = ey * fz - ez * fy;
        double ny = ez * fx - ex * fz;
        double nz = ex * fy - ey * fx;
        return Math.sqrt(nx * nx + ny * ny + nz * nz);
    }
}
