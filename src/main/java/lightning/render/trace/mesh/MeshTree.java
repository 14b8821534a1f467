package lightning.render.trace.mesh;

import java.util.Map;
import java.util.WeakHashMap;
import lightning.scene.Mesh;

/**
 * BVH over the triangles of a mesh as flat arrays: up to eight children per node, up to eight triangles with their vertices per
 * leaf.
 *
 * <p>Child {@code c} of node {@code n} is {@code child[8 n + c]}: the index of a node or, if negative, the complement of a
 * leaf; unused children are {@link #NONE} and come last. Its box is exact: along axis {@code a} from
 * {@code box[48 n + 16 a + c]} to {@code box[48 n + 16 a + 8 + c]}; {@link #EMPTY_BOUND} for unused children. Slot {@code s} of
 * leaf {@code l} has the triangle {@code triangle[8 l + s]} of the mesh, or −1; coordinate {@code a} of its vertex {@code v} is
 * {@code vertex[72 l + 24 v + 8 a + s]}, NaN for an empty slot. The root is node 0; it has no children if the mesh has no
 * triangles.
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
    /** Floats per leaf for vertices. */
    static final int LEAF_FLOATS = 9 * WIDTH;
    /** Floats from one vertex of a leaf's triangle to the next. */
    static final int VERTEX_FLOATS = 3 * WIDTH;

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

    /** Returns the bytes of its arrays. */
    public long bytes() {
        return 4L * (box.length + child.length + vertex.length + triangle.length);
    }
}
