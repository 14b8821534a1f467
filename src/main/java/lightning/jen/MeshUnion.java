package lightning.jen;

import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import lightning.mesh.Mesh;

/** Several meshes as one. */
final class MeshUnion {
    private MeshUnion() {}

    /**
     * The triangles of all meshes, in their order. Where only some have normals, the others' triangles get vertices of their own
     * and are flat all the same; missing texture coordinates are 0, missing colours white.
     */
    static Mesh of(List<Mesh> meshes) {
        boolean normals = meshes.stream().anyMatch(m -> m.normals() != null);
        List<Mesh> all = meshes.stream().map(m -> normals && m.normals() == null ? faceted(m) : m).toList();
        int[] triangles = new int[all.stream().mapToInt(m -> m.triangles().length).sum()];
        int at = 0;
        int vertices = 0;
        for (Mesh mesh : all) {
            for (int vertex : mesh.triangles()) {
                triangles[at++] = vertices + vertex;
            }
            vertices += mesh.vertexCount();
        }
        return new Mesh(column(all, Mesh::positions, 3, 0), triangles, normals ? column(all, Mesh::normals, 3, 0) : null,
                all.stream().anyMatch(m -> m.coordinates() != null) ? column(all, Mesh::coordinates, 2, 0) : null,
                all.stream().anyMatch(m -> m.colors() != null) ? column(all, Mesh::colors, 3, 1) : null);
    }

    private static float[] column(List<Mesh> meshes, Function<Mesh, float[]> of, int each, float missing) {
        float[] column = new float[meshes.stream().mapToInt(m -> each * m.vertexCount()).sum()];
        int at = 0;
        for (Mesh mesh : meshes) {
            float[] own = of.apply(mesh);
            int length = each * mesh.vertexCount();
            if (own == null) {
                Arrays.fill(column, at, at + length, missing);
            } else {
                System.arraycopy(own, 0, column, at, length);
            }
            at += length;
        }
        return column;
    }

    /** The same triangles, each with vertices of its own, whose normals are the triangle's; a triangle without area gets any. */
    private static Mesh faceted(Mesh m) {
        int[] t = m.triangles();
        float[] normals = new float[3 * t.length];
        int[] triangles = new int[t.length];
        for (int i = 0; i < t.length; i++) {
            triangles[i] = i;
            if (i % 3 == 0) {
                normal(m.positions(), 3 * t[i], 3 * t[i + 1], 3 * t[i + 2], normals, 3 * i);
            }
        }
        return new Mesh(spread(m.positions(), t, 3), triangles, normals, spread(m.coordinates(), t, 2), spread(m.colors(), t, 3));
    }

    private static float[] spread(float[] numbers, int[] vertices, int each) {
        if (numbers == null) {
            return null;
        }
        float[] spread = new float[each * vertices.length];
        for (int i = 0; i < vertices.length; i++) {
            System.arraycopy(numbers, each * vertices[i], spread, each * i, each);
        }
        return spread;
    }

    private static void normal(float[] p, int a, int b, int c, float[] to, int at) {
        double ex = (double) p[b] - p[a];
        double ey = (double) p[b + 1] - p[a + 1];
        double ez = (double) p[b + 2] - p[a + 2];
        double fx = (double) p[c] - p[a];
        double fy = (double) p[c + 1] - p[a + 1];
        double fz = (double) p[c + 2] - p[a + 2];
        double x = ey * fz - ez * fy;
        double y = ez * fx - ex * fz;
        double z = ex * fy - ey * fx;
        double length = Math.sqrt(x * x + y * y + z * z);
        boolean flat = !(length > 0);
        for (int v = 0; v < 3; v++) {
            to[at + 3 * v] = flat ? 1 : (float) (x / length);
            to[at + 3 * v + 1] = flat ? 0 : (float) (y / length);
            to[at + 3 * v + 2] = flat ? 0 : (float) (z / length);
        }
    }
}
