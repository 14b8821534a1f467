package lightning.format.nff;

import lightning.format.mesh.CornerTable;
import lightning.format.mesh.FloatList;
import lightning.format.mesh.IntList;
import lightning.format.mesh.Normals;
import lightning.format.mesh.Polygon;
import lightning.scene.Mesh;

/** A mesh in the making: polygons, or patches, of one fill. Corners at one place, with one normal, are one vertex. */
final class SurfaceMaker {
    final int fill;
    private final boolean smooth;
    private final CornerTable places = new CornerTable();
    private final CornerTable directions = new CornerTable();
    private final CornerTable corners = new CornerTable();
    private final FloatList positions = new FloatList();
    private final FloatList normals = new FloatList();
    private final IntList outline = new IntList();
    private final IntList cut = new IntList();
    private final IntList triangles = new IntList();

    /** @param smooth whether each corner has a normal */
    SurfaceMaker(int fill, boolean smooth) {
        this.fill = fill;
        this.smooth = smooth;
    }

    /** Begins a polygon. */
    void begin() {
        outline.clear();
    }

    /** The next corner of the polygon, with its normal, which is 0 where there is none. */
    void corner(float x, float y, float z, float nx, float ny, float nz) {
        int vertex = corners.number(number(places, x, y, z), number(directions, nx, ny, nz), 0);
        if (3 * vertex == positions.size()) {
            add(positions, x, y, z);
            add(normals, nx, ny, nz);
        }
        outline.add(vertex);
    }

    private static int number(CornerTable table, float x, float y, float z) {
        return table.number(bits(x), bits(y), bits(z));
    }

    /** 0 and −0 are one place. */
    private static int bits(float v) {
        return Float.floatToIntBits(v + 0f);
    }

    private static void add(FloatList to, float x, float y, float z) {
        to.add(x);
        to.add(y);
        to.add(z);
    }

    /** Cuts the polygon, which has at least three corners, into triangles. */
    void end(Polygon polygon) {
        cut.clear();
        polygon.triangulate(outline.array(), outline.size(), positions.array(), cut);
        for (int i = 0; i < cut.size(); i++) {
            triangles.add(outline.get(cut.get(i)));
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

    /** @throws IllegalArgumentException if a coordinate is beyond a mesh's range */
    Mesh mesh() {
        float[] p = positions.toArray();
        int[] t = triangles.toArray();
        float[] n = null;
        if (smooth) {
            n = normals.toArray();
            Normals.makeUnit(n, p, t);
        }
        return new Mesh(p, t, n, null, null);
    }
}
