package lightning.format.jen;

import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import lightning.format.mesh.Normals;
import lightning.scene.Mesh;

/** Several meshes as one. */
final class MeshUnion {
    private MeshUnion() {}

    /**
     * The triangles of all meshes, in their order. Where only some have normals, the others' triangles get vertices of their own
     * and are flat all the same; missing texture coordinates are 0, missing colours white, missing tangents none.
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
                all.stream().anyMatch(m -> m.colors() != null) ? column(all, Mesh::colors, 3, 1) : null,
                all.stream().anyMatch(m -> m.tangents() != null) ? tangents(all) : null);
    }

    private static float[] tangents(List<Mesh> meshes) {
        float[] tangents = column(meshes, Mesh::tangents, 4, 0);
        for (int i = 3; i < tangents.length; i += 4) {
            tangents[i] = tangents[i] < 0 ? -1 : 1;
        }
        return tangents;
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
        int[] vertices = m.triangles();
        float[] positions = spread(m.positions(), vertices, 3);
        int[] triangles = new int[vertices.length];
        Arrays.setAll(triangles, i -> i);
        return new Mesh(positions, triangles, Normals.smooth(positions, triangles), spread(m.coordinates(), vertices, 2),
                spread(m.colors(), vertices, 3));
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
}
