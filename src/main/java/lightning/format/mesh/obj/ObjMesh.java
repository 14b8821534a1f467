package lightning.format.mesh.obj;

import lightning.format.mesh.CornerTable;
import lightning.format.mesh.FloatList;
import lightning.format.mesh.IntList;
import lightning.format.mesh.Normals;
import lightning.scene.Mesh;

/** A mesh in the making: faces of one object and one material. */
final class ObjMesh {
    /** A corner without texture coordinates, or without a normal where surfaces are flat. */
    static final int NONE = -1;
    private static final int POSITION = 0;
    private static final int COORDINATE = 1;
    private static final int NORMAL = 2;

    final String object;
    final String material;
    private final CornerTable corners = new CornerTable();
    private final IntList triangles = new IntList();

    ObjMesh(String object, String material) {
        this.object = object;
        this.material = material;
    }

    /** The key of a corner without a normal in a group of faces that are smooth together, {@code smooth} ≥ 1. */
    static int smoothNormal(int smooth) {
        return NONE - smooth;
    }

    /** The vertex of a corner: indices from 0, {@link #NONE}, or a {@link #smoothNormal}. */
    int vertex(int position, int coordinate, int normal) {
        return corners.number(position, coordinate, normal);
    }

    void triangle(int a, int b, int c) {
        triangles.add(a);
        triangles.add(b);
        triangles.add(c);
    }

    boolean hasTriangles() {
        return triangles.size() > 0;
    }

    Mesh mesh(ObjPoints points) {
        int[] sharp = triangles.toArray();
        IntList sources = new IntList();
        for (int i = 0; i < corners.size(); i++) {
            sources.add(i);
        }
        boolean normals = any(NORMAL, NONE);
        if (normals) {
            splitFlat(sharp, sources);
        }
        float[] positions = taken(points.positions, 3, sources, POSITION);
        return new Mesh(positions, sharp, normals ? normals(points, sources, positions, sharp) : null,
                any(COORDINATE, NONE) ? taken(points.coordinates, 2, sources, COORDINATE) : null,
                points.colors.size() > 0 ? taken(points.colors, 3, sources, POSITION) : null);
    }

    private boolean any(int which, int but) {
        for (int i = 0; i < corners.size(); i++) {
            if (corners.key(i, which) != but) {
                return true;
            }
        }
        return false;
    }

    /** Gives each flat triangle vertices of its own, beside others that are smooth. */
    private void splitFlat(int[] sharp, IntList sources) {
        for (int i = 0; i < sharp.length; i++) {
            if (corners.key(sharp[i], NORMAL) == NONE) {
                sources.add(sharp[i]);
                sharp[i] = sources.size() - 1;
            }
        }
    }

    private float[] taken(FloatList from, int each, IntList sources, int which) {
        float[] to = new float[each * sources.size()];
        for (int i = 0; i < sources.size(); i++) {
            int key = corners.key(sources.get(i), which);
            for (int j = 0; key >= 0 && j < each; j++) {
                to[each * i + j] = from.get(each * key + j);
            }
        }
        return to;
    }

    /** Those of the file; else of the triangle alone, or of all triangles of the same group around the position. */
    private float[] normals(ObjPoints points, IntList sources, float[] positions, int[] sharp) {
        float[] normals = taken(points.normals, 3, sources, NORMAL);
        float[] smooth = null;
        int[] places = new int[sources.size()];
        if (anySmooth()) {
            var shared = new CornerTable();
            for (int i = 0; i < places.length; i++) {
                // Flat vertices stand alone; texture coordinates do not part what is smooth.
                int normal = corners.key(sources.get(i), NORMAL);
                places[i] = normal == NONE ? shared.number(i, 1, 0) : shared.number(corners.key(sources.get(i), POSITION), 0, normal);
            }
            float[] at = new float[3 * shared.size()];
            for (int i = 0; i < places.length; i++) {
                System.arraycopy(positions, 3 * i, at, 3 * places[i], 3);
            }
            int[] around = new int[sharp.length];
            for (int i = 0; i < sharp.length; i++) {
                around[i] = places[sharp[i]];
            }
            smooth = Normals.smooth(at, around);
        }
        for (int i = 0; smooth != null && i < places.length; i++) {
            if (corners.key(sources.get(i), NORMAL) < NONE) {
                System.arraycopy(smooth, 3 * places[i], normals, 3 * i, 3);
            }
        }
        Normals.makeUnit(normals, positions, sharp);
        return normals;
    }

    private boolean anySmooth() {
        for (int i = 0; i < corners.size(); i++) {
            if (corners.key(i, NORMAL) < NONE) {
                return true;
            }
        }
        return false;
    }
}
