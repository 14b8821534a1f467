package lightning.render.trace.mesh;

import lightning.base.Initializer;
import lightning.scene.node.Mesh;

/** Point on a triangle of a mesh with its barycentric weights, in the space of the mesh. Reused. */
public final class TrianglePoint {
    private Mesh mesh;
    private final int[] vertex = new int[3];
    private final double[] weight = new double[3];
    /** Direction perpendicular to the triangle, of any length, toward its front; 0 for a triangle without area. */
    public double nx;
    public double ny;
    public double nz;
    private double px;
    private double py;
    private double pz;

    /** Sets a triangle and a point on it. */
    @Initializer
    public void setPoint(Mesh newMesh, int triangle, double x, double y, double z) {
        mesh = newMesh;
        px = x;
        py = y;
        pz = z;
        float[] p = newMesh.positions();
        for (int v = 0; v < 3; v++) {
            vertex[v] = newMesh.triangles()[3 * triangle + v];
        }
        int a = 3 * vertex[0];
        int b = 3 * vertex[1];
        int c = 3 * vertex[2];
        double ex = (double) p[b] - p[a];
        double ey = (double) p[b + 1] - p[a + 1];
        double ez = (double) p[b + 2] - p[a + 2];
        double fx = (double) p[c] - p[a];
        double fy = (double) p[c + 1] - p[a + 1];
        double fz = (double) p[c + 2] - p[a + 2];
        nx = ey * fz - ez * fy;
        ny = ez * fx - ex * fz;
        nz = ex * fy - ey * fx;
        computeWeights(a, b, c);
    }

    /**
     * Computes the barycentric weights from the areas opposite the vertices, projected along the axis that the triangle faces
     * most.
     */
    private void computeWeights(int a, int b, int c) {
        float[] p = mesh.positions();
        double absX = Math.abs(nx);
        double absY = Math.abs(ny);
        double absZ = Math.abs(nz);
        int i = absX >= absY && absX >= absZ ? 1 : absY >= absZ ? 2 : 0;
        int j = i == 2 ? 0 : i + 1;
        double x = i == 0 ? px : i == 1 ? py : pz;
        double y = j == 0 ? px : j == 1 ? py : pz;
        double ax = p[a + i] - x;
        double ay = p[a + j] - y;
        double bx = p[b + i] - x;
        double by = p[b + j] - y;
        double cx = p[c + i] - x;
        double cy = p[c + j] - y;
        double area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
        double weightA = clampWeight((bx * cy - by * cx) / area);
        double weightB = clampWeight((cx * ay - cy * ax) / area);
        double weightC = clampWeight((ax * by - ay * bx) / area);
        double sum = weightA + weightB + weightC;
        weight[0] = sum > 0 ? weightA / sum : 1;
        weight[1] = sum > 0 ? weightB / sum : 0;
        weight[2] = sum > 0 ? weightC / sum : 0;
    }

    /** Clamps a weight: rounding may move the point slightly outside, and a triangle without area has NaN weights. */
    private static double clampWeight(double v) {
        return v > 0 ? v < 1 ? v : 1 : 0;
    }

    /** Returns whether the mesh has vertex normals. */
    public boolean isSmooth() {
        return mesh.normals() != null;
    }

    /** Returns the barycentric weight of vertex {@code v}, 0 1 2: from 0 to 1; their sum is 1. */
    public double weight(int v) {
        return weight[v];
    }

    /** Returns coordinate {@code axis} of the normal at vertex {@code v}. */
    public double normal(int v, int axis) {
        float[] n = mesh.normals();
        assert n != null;
        return n[3 * vertex[v] + axis];
    }

    /** Returns whether the mesh has vertex tangents. */
    public boolean hasTangents() {
        return mesh.tangents() != null;
    }

    /** Returns coordinate {@code axis} of the interpolated tangent, of any length; 3 for the handedness, below 0 for −1. */
    public double tangent(int axis) {
        float[] t = mesh.tangents();
        assert t != null;
        return weight[0] * t[4 * vertex[0] + axis] + weight[1] * t[4 * vertex[1] + axis] + weight[2] * t[4 * vertex[2] + axis];
    }

    /** Writes the mean of x, y and z of the vertices, {@code float[3 * vertices]}, at the point, to {@code to[0 … 2]}. */
    public void interpolate(float[] t, double[] to) {
        for (int axis = 0; axis < 3; axis++) {
            to[axis] = weight[0] * t[3 * vertex[0] + axis] + weight[1] * t[3 * vertex[1] + axis] + weight[2] * t[3 * vertex[2] + axis];
        }
    }

    /** Writes the unit direction in which u grows over the triangle to {@code to[0 … 2]}; 0 for none. The mesh must have texture coordinates. */
    public void growthOfU(double[] to) {
        VertexTangents.writeGrowthOfU(mesh, vertex[0], vertex[1], vertex[2], to);
    }

    /**
     * Returns the signed distance of the point in front of the plane through vertex {@code v} perpendicular to the normal
     * there.
     */
    public double tangentPlaneDistance(int v) {
        float[] n = mesh.normals();
        assert n != null;
        return planeDistance(v, n);
    }

    /** Returns the same for the plane perpendicular to another direction at the vertex, {@code float[3 * vertices]}. */
    public double planeDistance(int v, float[] n) {
        float[] p = mesh.positions();
        int i = 3 * vertex[v];
        return (px - p[i]) * n[i] + (py - p[i + 1]) * n[i + 1] + (pz - p[i + 2]) * n[i + 2];
    }

    /**
     * Returns red, green or blue, {@code channel} 0 1 2, of the interpolated vertex color, from 0 to 1. The mesh must have
     * vertex colors.
     */
    public double color(int channel) {
        float[] c = mesh.colors();
        assert c != null;
        double value = weight[0] * c[3 * vertex[0] + channel] + weight[1] * c[3 * vertex[1] + channel]
                + weight[2] * c[3 * vertex[2] + channel];
        // Clamps rounded weights, and makes zero positive.
        return value < 1 ? value > 0 ? value : 0 : 1;
    }

    /** Returns the texture coordinate: horizontal for {@code axis} 0, upward for 1; 0 if the mesh has none. */
    public double textureCoordinate(int axis) {
        float[] c = mesh.coordinates();
        return c == null ? 0 : weight[0] * c[2 * vertex[0] + axis] + weight[1] * c[2 * vertex[1] + axis]
                + weight[2] * c[2 * vertex[2] + axis];
    }

    /**
     * Writes the gradient of a texture coordinate over the triangle, {@code axis} 0 or 1, to {@code to[i … i + 2]}; 0 if there
     * is none. For edges e and f from the first vertex, along which it grows by p and q, and n = e × f, it is (p·(f × n) + q·(n
     * × e)) / n².
     */
    public void textureGradient(int axis, double[] to, int i) {
        float[] p = mesh.positions();
        float[] c = mesh.coordinates();
        double square = nx * nx + ny * ny + nz * nz;
        if (c == null || !(square > 0)) {
            to[i] = 0;
            to[i + 1] = 0;
            to[i + 2] = 0;
            return;
        }
        int a = 3 * vertex[0];
        double growE = ((double) c[2 * vertex[1] + axis] - c[2 * vertex[0] + axis]) / square;
        double growF = ((double) c[2 * vertex[2] + axis] - c[2 * vertex[0] + axis]) / square;
        double x = growE * edge(p, 2, a, 0) - growF * edge(p, 1, a, 0);
        double y = growE * edge(p, 2, a, 1) - growF * edge(p, 1, a, 1);
        double z = growE * edge(p, 2, a, 2) - growF * edge(p, 1, a, 2);
        to[i] = y * nz - z * ny;
        to[i + 1] = z * nx - x * nz;
        to[i + 2] = x * ny - y * nx;
    }

    private double edge(float[] p, int to, int from, int axis) {
        return (double) p[3 * vertex[to] + axis] - p[from + axis];
    }
}
