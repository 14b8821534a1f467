package lightning.format.nff;

import lightning.format.mesh.FloatList;
import lightning.format.mesh.IntList;
import lightning.format.mesh.PolygonTriangulator;
import lightning.format.mesh.VertexKeyTable;
import lightning.format.mesh.VertexNormals;
import lightning.scene.node.Mesh;

/** Mutable builder of a mesh: polygons, or patches, of one fill. Corners with equal position and normal share a vertex. */
final class MeshBuilder {
    final int fill;
    private final boolean smooth;
    private final VertexKeyTable positionKeys = new VertexKeyTable();
    private final VertexKeyTable normalKeys = new VertexKeyTable();
    private final VertexKeyTable vertexKeys = new VertexKeyTable();
    private final FloatList positions = new FloatList();
    private final FloatList normals = new FloatList();
    private final IntList outline = new IntList();
    private final IntList polygonTriangles = new IntList();
    private final IntList triangles = new IntList();

    /**
     * Creates a builder.
     *
     * @param smooth true if each corner has a normal
     */
    MeshBuilder(int fill, boolean smooth) {
        this.fill = fill;
        this.smooth = smooth;
    }

    /** Starts a polygon. */
    void beginPolygon() {
        outline.clear();
    }

    /** Adds a corner of the polygon with its normal, 0 for none. */
    void addCorner(float x, float y, float z, float nx, float ny, float nz) {
        int vertex = vertexKeys.findOrAdd(keyOf(positionKeys, x, y, z), keyOf(normalKeys, nx, ny, nz), 0);
        if (3 * vertex == positions.size()) {
            add(positions, x, y, z);
            add(normals, nx, ny, nz);
        }
        outline.add(vertex);
    }

    private static int keyOf(VertexKeyTable table, float x, float y, float z) {
        return table.findOrAdd(bits(x), bits(y), bits(z));
    }

    /** Returns the bits of a coordinate; 0 and −0 are equal. */
    private static int bits(float v) {
        return Float.floatToIntBits(v + 0f);
    }

    private static void add(FloatList out, float x, float y, float z) {
        out.add(x);
        out.add(y);
        out.add(z);
    }

    /** Triangulates the polygon, which has at least three corners. */
    void endPolygon(PolygonTriangulator polygon) {
        polygonTriangles.clear();
        polygon.triangulate(outline.array(), outline.size(), positions.array(), polygonTriangles);
        for (int i = 0; i < polygonTriangles.size(); i++) {
            triangles.add(outline.get(polygonTriangles.get(i)));
        }
    }

    int vertexCount() {
        return positions.size() / 3;
    }

    int triangleCount() {
        return triangles.size() / 3;
    }

    boolean isSmooth() {
        return smooth;
    }

    /**
     * Returns the mesh.
     *
     * @throws IllegalArgumentException if a coordinate is out of a mesh's range
     */
    Mesh mesh() {
        float[] p = positions.toArray();
        int[] t = triangles.toArray();
        float[] n = null;
        if (smooth) {
            n = normals.toArray();
            VertexNormals.normalizeAll(n, p, t);
        }
        return new Mesh(p, t, n, null, null);
    }
}
