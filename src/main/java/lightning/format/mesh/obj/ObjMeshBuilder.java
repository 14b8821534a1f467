package lightning.format.mesh.obj;

import lightning.format.mesh.FloatList;
import lightning.format.mesh.IntList;
import lightning.format.mesh.VertexKeyTable;
import lightning.format.mesh.VertexNormals;
import lightning.scene.node.Mesh;

/** Mutable builder of a mesh: faces of one object and one material. */
final class ObjMeshBuilder {
    /** Index of a missing texture coordinate, or of the normal in a flat face. */
    static final int NONE = -1;
    private static final int POSITION = 0;
    private static final int COORDINATE = 1;
    private static final int NORMAL = 2;

    final String object;
    final String material;
    private final VertexKeyTable corners = new VertexKeyTable();
    private final IntList triangles = new IntList();

    ObjMeshBuilder(String object, String material) {
        this.object = object;
        this.material = material;
    }

    /** Returns the key for a corner without a normal in a smoothing group, {@code smoothingGroup} ≥ 1. */
    static int smoothNormal(int smoothingGroup) {
        return NONE - smoothingGroup;
    }

    /** Returns the vertex of a corner: indices from 0, {@link #NONE}, or a {@link #smoothNormal}. */
    int addVertex(int position, int coordinate, int normal) {
        return corners.findOrAdd(position, coordinate, normal);
    }

    void addTriangle(int a, int b, int c) {
        triangles.add(a);
        triangles.add(b);
        triangles.add(c);
    }

    boolean hasTriangles() {
        return triangles.size() > 0;
    }

    Mesh build(ObjVertexData points) {
        int[] indices = triangles.toArray();
        IntList sources = new IntList();
        for (int i = 0; i < corners.size(); i++) {
            sources.add(i);
        }
        boolean normals = hasOtherThan(NORMAL, NONE);
        if (normals) {
            splitFlat(indices, sources);
        }
        float[] positions = gather(points.positions, 3, sources, POSITION);
        return new Mesh(positions, indices, normals ? normals(points, sources, positions, indices) : null,
                hasOtherThan(COORDINATE, NONE) ? gather(points.coordinates, 2, sources, COORDINATE) : null,
                points.colors.size() > 0 ? gather(points.colors, 3, sources, POSITION) : null);
    }

    private boolean hasOtherThan(int component, int excluded) {
        for (int i = 0; i < corners.size(); i++) {
            if (corners.key(i, component) != excluded) {
                return true;
            }
        }
        return false;
    }

    /** Gives flat triangles their own vertices, separate from smooth ones. */
    private void splitFlat(int[] indices, IntList sources) {
        for (int i = 0; i < indices.length; i++) {
            if (corners.key(indices[i], NORMAL) == NONE) {
                sources.add(indices[i]);
                indices[i] = sources.size() - 1;
            }
        }
    }

    private float[] gather(FloatList values, int components, IntList sources, int component) {
        float[] result = new float[components * sources.size()];
        for (int i = 0; i < sources.size(); i++) {
            int key = corners.key(sources.get(i), component);
            for (int j = 0; key >= 0 && j < components; j++) {
                result[components * i + j] = values.get(components * key + j);
            }
        }
        return result;
    }

    /**
     * Returns the normals: those of the file, else of the single triangle, or the mean of the smoothing group around the
     * position.
     */
    private float[] normals(ObjVertexData points, IntList sources, float[] positions, int[] indices) {
        float[] normals = gather(points.normals, 3, sources, NORMAL);
        float[] smooth = null;
        int[] sharedIndices = new int[sources.size()];
        if (hasSmoothCorners()) {
            var shared = new VertexKeyTable();
            for (int i = 0; i < sharedIndices.length; i++) {
                // Flat vertices are independent; differing texture coordinates do not split smooth normals.
                int normal = corners.key(sources.get(i), NORMAL);
                sharedIndices[i] =
                        normal == NONE ? shared.findOrAdd(i, 1, 0) : shared.findOrAdd(corners.key(sources.get(i), POSITION), 0, normal);
            }
            float[] sharedPositions = new float[3 * shared.size()];
            for (int i = 0; i < sharedIndices.length; i++) {
                System.arraycopy(positions, 3 * i, sharedPositions, 3 * sharedIndices[i], 3);
            }
            int[] sharedTriangles = new int[indices.length];
            for (int i = 0; i < indices.length; i++) {
                sharedTriangles[i] = sharedIndices[indices[i]];
            }
            smooth = VertexNormals.smooth(sharedPositions, sharedTriangles);
        }
        for (int i = 0; smooth != null && i < sharedIndices.length; i++) {
            if (corners.key(sources.get(i), NORMAL) < NONE) {
                System.arraycopy(smooth, 3 * sharedIndices[i], normals, 3 * i, 3);
            }
        }
        VertexNormals.normalizeAll(normals, positions, indices);
        return normals;
    }

    private boolean hasSmoothCorners() {
        for (int i = 0; i < corners.size(); i++) {
            if (corners.key(i, NORMAL) < NONE) {
                return true;
            }
        }
        return false;
    }
}
