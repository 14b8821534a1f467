package lightning.render.trace.mesh;

import java.util.Map;
import java.util.WeakHashMap;
import lightning.scene.node.Mesh;

/**
 * BVH over the triangles of a mesh as flat arrays: up to eight children per node, up to eight triangles with their vertices per
 * leaf.
 *
 * <p>Child {@code c} of node {@code n} is {@code child[8 n + c]}: the index of a node or, if negative, the complement of a
 * leaf; unused children are {@link #NONE} and come last. Its box is exact: along axis {@code a} from
 * {@code box[48 n + 16 a + c]} to {@code box[48 n + 16 a + 8 + c]}; {@link #EMPTY_BOUND} for unused children. The root is node
 * 0; it has no children if the mesh has no triangles.
 *
 * <p>A leaf has four strips of four vertices ({@link TrianglePairs}), one for two triangles: the first three vertices of strip
 * {@code s} form the triangle of slot {@code s}, the last three that of slot {@code s + 4}. Coordinate {@code a} of corner
 * {@code k} of slot {@code s} of leaf {@code l} is {@code vertex[48 l + 16 a + 4 k + s]}, so that eight adjacent floats are a
 * corner of all slots. Missing vertices are NaN. {@code triangle[8 l + s]} stores the triangle of the mesh and which corner is its
 * last vertex ({@link #id}, {@link #lastCorner}), or is negative for an empty slot. The triangle's vertices run through the corners
 * in ascending cyclic order in the first four slots and in descending order in the others ({@link #corner}).
 */
public final class MeshTree {
    static final int WIDTH = 8;
    /** Marks an unused child of a node. */
    static final int NONE = Integer.MIN_VALUE;
    /**
     * Bound of an unused box: its minimum is this and its maximum is the negative. Every line leaves such a box before entering
     * it, and a beam enters it beyond {@link MeshBeam}'s maximum distance.
     */
    static final float EMPTY_BOUND = Float.MAX_VALUE;
    /** Floats per node for boxes. */
    static final int NODE_FLOATS = 6 * WIDTH;
    /** Strips per leaf, of two triangles each. */
    static final int STRIPS = WIDTH / 2;
    /** Floats from one corner of a leaf's triangle to the next. */
    static final int CORNER_FLOATS = STRIPS;
    /** Floats from one coordinate of a leaf's vertices to the next. */
    static final int AXIS_FLOATS = 4 * STRIPS;
    /** Floats per leaf for vertices. */
    static final int LEAF_FLOATS = 3 * AXIS_FLOATS;
    /** Bits of {@link #triangle} below the triangle. */
    static final int CORNER_BITS = 2;

    /** BVHs of the meshes in use. A BVH must not reference its mesh, or the weak key would never be released. */
    private static final Map<Mesh, MeshTree> CACHE = new WeakHashMap<>();

    final float[] box;
    final int[] child;
    final float[] vertex;
    final int[] triangle;
    /** Bounds of the mesh: min x y z, max x y z; 0 without triangles. */
    final float[] bounds;
    /** Largest absolute coordinate. */
    final double maxCoordinate;
    /** Upper bound of the stack size: all but one child of every node on a path are pushed. */
    final int stackSize;

    MeshTree(float[] box, int[] child, float[] vertex, int[] triangle, float[] bounds, int depth) {
        this.box = box;
        this.child = child;
        this.vertex = vertex;
        this.triangle = triangle;
        this.bounds = bounds;
        double max = 0;
        for (float b : bounds) {
            max = Math.max(max, Math.abs(b));
        }
        maxCoordinate = max;
        stackSize = WIDTH * (depth + 1);
    }

    /**
     * Returns the BVH of a mesh. It is built once for all callers while the mesh is in use, with as many threads as there are
     * processors.
     */
    public static MeshTree of(Mesh mesh) {
        synchronized (CACHE) {
            return CACHE.computeIfAbsent(mesh, m -> MeshTreeBuilder.build(m));
        }
    }

    /** Returns the triangle of a slot, negative if it is empty. */
    static int id(int reference) {
        return reference >> CORNER_BITS;
    }

    /** Returns the corner that is the last vertex of the triangle of a slot. */
    static int lastCorner(int reference) {
        return reference & 3;
    }

    /** Returns the index of the first coordinate of a vertex, 0 1 2, of a leaf's triangle in {@link #vertex}. */
    int corner(int leaf, int slot, int v) {
        int last = lastCorner(triangle[WIDTH * leaf + slot]);
        // The last vertex has the last corner; the first vertex is the next corner in ascending or descending order.
        int k = last + (slot < STRIPS ? v + 1 : 2 - v);
        return LEAF_FLOATS * leaf + CORNER_FLOATS * (k % 3) + slot;
    }

    /** Returns the bytes of its arrays. */
    public long bytes() {
        return 4L * (box.length + child.length + vertex.length + triangle.length);
    }
}
