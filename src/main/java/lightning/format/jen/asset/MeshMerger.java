package lightning.format.jen.asset;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import lightning.format.mesh.VertexNormals;
import lightning.scene.node.Mesh;
import org.jspecify.annotations.Nullable;

/** Merges several meshes into one. */
final class MeshMerger {
    private MeshMerger() {}

    /**
     * Returns the triangles of all meshes, in order. If only some meshes have normals, the others' triangles get their own
     * vertices and stay flat. Missing texture coordinates become 0, missing colors white, missing tangents none.
     */
    static Mesh merge(List<Mesh> meshes) {
        boolean hasNormals = meshes.stream().anyMatch(m -> m.normals() != null);
        List<Mesh> uniform = meshes.stream().map(m -> hasNormals && m.normals() == null ? withFaceNormals(m) : m).toList();
        int[] triangles = new int[uniform.stream().mapToInt(m -> m.triangles().length).sum()];
        int index = 0;
        int vertices = 0;
        for (Mesh mesh : uniform) {
            for (int vertex : mesh.triangles()) {
                triangles[index++] = vertices + vertex;
            }
            vertices += mesh.vertexCount();
        }
        return new Mesh(concatenate(uniform, Mesh::positions, 3, 0), triangles,
                hasNormals ? concatenate(uniform, Mesh::normals, 3, 0) : null,
                uniform.stream().anyMatch(m -> m.coordinates() != null) ? concatenate(uniform, Mesh::coordinates, 2, 0) : null,
                uniform.stream().anyMatch(m -> m.colors() != null) ? concatenate(uniform, Mesh::colors, 3, 1) : null,
                uniform.stream().anyMatch(m -> m.tangents() != null) ? mergeTangents(uniform) : null);
    }

    private static float[] mergeTangents(List<Mesh> meshes) {
        float[] tangents = concatenate(meshes, Mesh::tangents, 4, 0);
        for (int i = 3; i < tangents.length; i += 4) {
            tangents[i] = tangents[i] < 0 ? -1 : 1;
        }
        return tangents;
    }

    private static float[] concatenate(List<Mesh> meshes, Function<Mesh, float[]> getter, int components, float missing) {
        float[] result = new float[meshes.stream().mapToInt(m -> components * m.vertexCount()).sum()];
        int offset = 0;
        for (Mesh mesh : meshes) {
            float[] values = getter.apply(mesh);
            int length = components * mesh.vertexCount();
            if (values == null) {
                Arrays.fill(result, offset, offset + length, missing);
            } else {
                System.arraycopy(values, 0, result, offset, length);
            }
            offset += length;
        }
        return result;
    }

    /** Returns the triangles with their own vertices and face normals; a triangle without area gets an arbitrary normal. */
    private static Mesh withFaceNormals(Mesh m) {
        int[] vertices = m.triangles();
        float[] positions = requireNonNull(expand(m.positions(), vertices, 3));
        int[] triangles = new int[vertices.length];
        Arrays.setAll(triangles, i -> i);
        return new Mesh(positions, triangles, VertexNormals.smooth(positions, triangles), expand(m.coordinates(), vertices, 2),
                expand(m.colors(), vertices, 3));
    }

    private static float @Nullable [] expand(float @Nullable [] values, int[] vertices, int components) {
        if (values == null) {
            return null;
        }
        float[] result = new float[components * vertices.length];
        for (int i = 0; i < vertices.length; i++) {
            System.arraycopy(values, components * vertices[i], result, components * i, components);
        }
        return result;
    }
}
