package lightning.render.trace.mesh;

import java.util.Arrays;
import lightning.scene.node.Mesh;

/**
 * Pairs of triangles that share an edge and are oriented alike, and the triangles that are left alone. Every triangle is in one pair.
 *
 * <p>A pair has four vertices in a strip: the first triangle has the first three, the second has the last three, and the edge
 * between is shared. A triangle alone has no fourth vertex. Vertices are compared by position, because meshes with flat triangles or seams
 * repeat them.
 *
 * <p>Most files list triangles with a common edge one after the other. The others find their partner by a hash of their edges.
 */
final class TrianglePairs {
    /** Maximum number of edges to look at for one: any number of triangles may share an edge. */
    private static final int MAX_PROBES = 16;

    private final float[] positions;
    private final int[] vertices;
    /** Triangles of each pair, with the corner of their last vertex as in {@link MeshTree#triangle}; −1 for none. */
    private int[] first;
    private int[] second;
    private int count;

    private TrianglePairs(Mesh mesh) {
        positions = mesh.positions();
        vertices = mesh.triangles();
        first = new int[mesh.triangleCount()];
        second = new int[mesh.triangleCount()];
    }

    /** Pairs the triangles of a mesh. */
    static TrianglePairs of(Mesh mesh) {
        TrianglePairs pairs = new TrianglePairs(mesh);
        pairs.pairRemaining(pairs.pairAdjacent(mesh.triangleCount()));
        pairs.first = Arrays.copyOf(pairs.first, pairs.count);
        pairs.second = Arrays.copyOf(pairs.second, pairs.count);
        return pairs;
    }

    /** Returns the number of pairs. */
    int count() {
        return count;
    }

    /** Returns the first triangle of a pair as in {@link MeshTree#triangle}. */
    int first(int pair) {
        return first[pair];
    }

    /** Returns the second triangle of a pair as in {@link MeshTree#triangle}, or −1. */
    int second(int pair) {
        return second[pair];
    }

    /** Returns vertex {@code k} of a pair's strip, or −1 if a triangle alone has none. */
    int vertex(int pair, int k) {
        if (k < 3) {
            return vertices[3 * MeshTree.id(first[pair]) + (2 - MeshTree.lastCorner(first[pair]) + k) % 3];
        }
        return second[pair] < 0 ? -1 : vertices[3 * MeshTree.id(second[pair]) + MeshTree.lastCorner(second[pair])];
    }

    /** Pairs triangles with the next one if they share an edge; returns the others. */
    private int[] pairAdjacent(int triangles) {
        int[] remaining = new int[triangles];
        int n = 0;
        for (int t = 0; t < triangles; t++) {
            if (t + 1 < triangles && pairWith(t, t + 1)) {
                t++;
            } else {
                remaining[n++] = t;
            }
        }
        return Arrays.copyOf(remaining, n);
    }

    private boolean pairWith(int t, int u) {
        for (int e = 3 * t; e < 3 * t + 3; e++) {
            for (int f = 3 * u; f < 3 * u + 3; f++) {
                if (areOpposite(e, f)) {
                    addPair(e, f);
                    return true;
                }
            }
        }
        return false;
    }

    /** Adds a pair with a shared edge. Edge {@code 3 t + k} of triangle t is that across from its vertex k. */
    private void addPair(int e, int f) {
        first[count] = e / 3 << MeshTree.CORNER_BITS | 2 - e % 3;
        second[count++] = f / 3 << MeshTree.CORNER_BITS | f % 3;
    }

    private void addSingle(int t) {
        first[count] = t << MeshTree.CORNER_BITS | 2;
        second[count++] = -1;
    }

    private void pairRemaining(int[] remaining) {
        int[] table = new int[Integer.highestOneBit(Math.max(1, remaining.length)) << 2];
        Arrays.fill(table, -1);
        boolean[] isPaired = new boolean[vertices.length / 3];
        for (int t : remaining) {
            int partner = -1;
            int e = 3 * t;
            for (; e < 3 * t + 3 && partner < 0; e++) {
                partner = findOpposite(table, isPaired, e);
            }
            if (partner >= 0) {
                addPair(partner, e - 1);
                isPaired[t] = true;
                isPaired[partner / 3] = true;
            } else {
                for (e = 3 * t; e < 3 * t + 3; e++) {
                    insert(table, e);
                }
            }
        }
        for (int t : remaining) {
            if (!isPaired[t]) {
                addSingle(t);
            }
        }
    }

    private int findOpposite(int[] table, boolean[] isPaired, int e) {
        int at = hash(end(e), start(e));
        for (int n = 0; n < MAX_PROBES; n++, at++) {
            int f = table[at & table.length - 1];
            if (f < 0) {
                return -1;
            }
            if (!isPaired[f / 3] && areOpposite(e, f)) {
                return f;
            }
        }
        return -1;
    }

    private void insert(int[] table, int e) {
        int at = hash(start(e), end(e));
        for (int n = 0; n < MAX_PROBES; n++, at++) {
            if (table[at & table.length - 1] < 0) {
                table[at & table.length - 1] = e;
                return;
            }
        }
    }

    /** Returns the vertex at which an edge starts. */
    private int start(int e) {
        return vertices[e % 3 == 2 ? e - 2 : e + 1];
    }

    private int end(int e) {
        return vertices[e % 3 == 0 ? e + 2 : e - 1];
    }

    private boolean areOpposite(int e, int f) {
        return isSame(start(e), end(f)) && isSame(end(e), start(f));
    }

    /** Returns whether two vertices have the same position, in every bit. */
    private boolean isSame(int v, int w) {
        return v == w || bits(v, 0) == bits(w, 0) && bits(v, 1) == bits(w, 1) && bits(v, 2) == bits(w, 2);
    }

    private int bits(int v, int axis) {
        return Float.floatToRawIntBits(positions[3 * v + axis]);
    }

    private int hash(int from, int to) {
        int h = 0;
        for (int a = 0; a < 3; a++) {
            h = (h ^ bits(from, a)) * 0x9E3779B1;
            h = (h ^ h >>> 15 ^ bits(to, a)) * 0x85EBCA6B;
        }
        return h ^ h >>> 16;
    }
}
