package lightning.scene.light;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import lightning.base.math.Vec3;
import lightning.scene.node.Mesh;

/**
 * Order and sides of the triangles of a mesh whose surface is a light, independent of its place.
 *
 * @param order triangles along a curve that fills space (Morton, A computer oriented geodetic data base, 1966), so that samples which are
 *     spread over the order are spread over the surface
 * @param side  of each triangle, by its own index: 1 or −1 if it is in a closed part whose outer side has this sign along the triangle's normal;
 *     0 in an open part
 */
record MeshSides(int[] order, byte[] side) {
    private static final int GRID_BITS = 10;
    /** Largest number of triangles of a mesh whose closed parts are found; a larger one counts as open, which is as bright with more noise. */
    private static final int MAX_TRIANGLES = 1 << 17;

    /** Position of a vertex. */
    private record Place(float x, float y, float z) {}

    static MeshSides of(Mesh mesh) {
        return new MeshSides(order(mesh), mesh.triangleCount() > MAX_TRIANGLES ? new byte[mesh.triangleCount()] : sides(mesh));
    }

    private static int[] order(Mesh mesh) {
        int count = mesh.triangleCount();
        double[] low = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
        double extent = 0;
        for (int i = 0; i < mesh.positions().length; i++) {
            low[i % 3] = Math.min(low[i % 3], mesh.positions()[i]);
        }
        for (int i = 0; i < mesh.positions().length; i++) {
            extent = Math.max(extent, mesh.positions()[i] - low[i % 3]);
        }
        double scale = extent > 0 ? ((1 << GRID_BITS) - 1) / extent : 0;
        long[] keys = new long[count];
        for (int t = 0; t < count; t++) {
            Vec3 middle = MeshSurface.corner(mesh, t, 0).plus(MeshSurface.corner(mesh, t, 1)).plus(MeshSurface.corner(mesh, t, 2))
                    .times(1.0 / 3);
            long key = spread((int) ((middle.x() - low[0]) * scale)) | spread((int) ((middle.y() - low[1]) * scale)) << 1
                    | spread((int) ((middle.z() - low[2]) * scale)) << 2;
            keys[t] = key << Integer.SIZE | t;
        }
        Arrays.sort(keys);
        return Arrays.stream(keys).mapToInt(key -> (int) key).toArray();
    }

    /** Returns a number with two zeros after each of its bits. */
    private static long spread(int v) {
        long spread = 0;
        for (int bit = 0; bit < GRID_BITS; bit++) {
            spread |= (long) (v >> bit & 1) << 3 * bit;
        }
        return spread;
    }

    private static byte[] sides(Mesh mesh) {
        int[] corners = weldedCorners(mesh);
        int count = mesh.triangleCount();
        var parts = new Parts(count);
        Map<Long, Integer> open = HashMap.newHashMap(3 * count);
        // An edge that is met a second time in the same direction never closes.
        for (int t = 0; t < count; t++) {
            for (int c = 0; c < 3; c++) {
                int from = corners[3 * t + c];
                int to = corners[3 * t + (c + 1) % 3];
                Integer opposite = open.remove(key(to, from));
                if (opposite != null) {
                    parts.join(t, opposite);
                } else {
                    Integer same = open.put(key(from, to), t);
                    if (same != null) {
                        parts.join(t, same);
                        parts.open(t);
                    }
                }
            }
        }
        open.values().forEach(parts::open);
        double[] volume = new double[count];
        for (int t = 0; t < count; t++) {
            volume[parts.root(t)] +=
                    MeshSurface.corner(mesh, t, 0).dot(MeshSurface.corner(mesh, t, 1).cross(MeshSurface.corner(mesh, t, 2)));
        }
        byte[] side = new byte[count];
        for (int t = 0; t < count; t++) {
            side[t] = parts.isOpen(t) ? 0 : (byte) Math.signum(volume[parts.root(t)]);
        }
        return side;
    }

    private static long key(int from, int to) {
        return (long) from << Integer.SIZE | to;
    }

    /** Returns the corners of all triangles, where vertices at the same position are the same. */
    private static int[] weldedCorners(Mesh mesh) {
        Map<Place, Integer> known = HashMap.newHashMap(mesh.vertexCount());
        int[] welded = new int[mesh.vertexCount()];
        for (int i = 0; i < welded.length; i++) {
            var place = new Place(mesh.positions()[3 * i] + 0f, mesh.positions()[3 * i + 1] + 0f, mesh.positions()[3 * i + 2] + 0f);
            Integer first = known.putIfAbsent(place, i);
            welded[i] = first == null ? i : first;
        }
        return Arrays.stream(mesh.triangles()).map(vertex -> welded[vertex]).toArray();
    }

    /** Connected parts of a mesh: a forest of triangles (Galler and Fischer, An improved equivalence algorithm, 1964). */
    private static final class Parts {
        private final int[] parent;
        /** By root. */
        private final boolean[] isOpen;

        Parts(int triangles) {
            parent = new int[triangles];
            Arrays.setAll(parent, t -> t);
            isOpen = new boolean[triangles];
        }

        int root(int triangle) {
            int t = triangle;
            while (parent[t] != t) {
                parent[t] = parent[parent[t]];
                t = parent[t];
            }
            return t;
        }

        void join(int a, int b) {
            int from = root(a);
            int to = root(b);
            parent[from] = to;
            isOpen[to] |= isOpen[from];
        }

        void open(int triangle) {
            isOpen[root(triangle)] = true;
        }

        boolean isOpen(int triangle) {
            return isOpen[root(triangle)];
        }
    }
}
