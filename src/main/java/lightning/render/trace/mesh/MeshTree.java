package lightning.render.trace.mesh;

import java.util.Map;
import java.util.WeakHashMap;
import lightning.scene.Mesh;

/**
 * A tree of boxes over the triangles of a mesh, as plain arrays: each node has up to eight children, each leaf up to eight
 * triangles with their vertices.
 *
 * <p>Child {@code c} of node {@code n} is {@code child[8 n + c]}: the index of a node or, where negative, the complement of a leaf;
 * children come before what is {@link #NONE}. Its box is exact: along axis {@code a} from {@code box[48 n + 16 a + c]} to
 * {@code box[48 n + 16 a + 8 + c]}; {@link #EMPTY_BOUND} where there is no child. Slot {@code s} of leaf {@code l} has the triangle {@code triangle[8 l + s]} of the mesh, or −1;
 * coordinate {@code a} of its vertex {@code v} is {@code vertex[72 l + 24 v + 8 a + s]}, NaN where there is no triangle. The root
 * is node 0; it has no child where the mesh has no triangle.
 */
public final class MeshTree {
    static final int WIDTH = 8;
    /** Stands where a node has no further child. */
    static final int NONE = Integer.MIN_VALUE;
    /**
     * Stands at the sides of a box that is not there, the lesser side at this and the greater at its negative: every line leaves
     * such a box before it enters it, and a beam enters it beyond {@link MeshBeam}'s farthest.
     */
    static final float EMPTY_BOUND = Float.MAX_VALUE;
    /** Floats of a node's boxes. */
    static final int NODE_FLOATS = 6 * WIDTH;
    /** Floats of a leaf's vertices. */
    static final int LEAF_FLOATS = 9 * WIDTH;
    /** Floats from one vertex of a leaf's triangle to the next. */
    static final int VERTEX_FLOATS = 3 * WIDTH;

    /** The trees of the meshes that anyone still has. A tree does not know its mesh. */
    private static final Map<Mesh, MeshTree> CACHE = new WeakHashMap<>();

    final float[] box;
    final int[] child;
    final float[] vertex;
    final int[] triangle;
    /** All of it: least x y z, greatest x y z; 0 where there is no triangle. */
    final float[] bounds;
    /** The largest absolute coordinate. */
    final double maxCoordinate;
    /** More than the nodes that are put aside at any time when all but one child of every node on a way are. */
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

    /** The tree of a mesh: built once for all who ask while the mesh is in use, by as many threads as there are processors. */
    public static MeshTree of(Mesh mesh) {
        synchronized (CACHE) {
            return CACHE.computeIfAbsent(mesh, m -> MeshTreeBuilder.build(m));
        }
    }

    /** The bytes of its arrays. */
    public long bytes() {
        return 4L * (box.length + child.length + vertex.length + triangle.length);
    }
}
