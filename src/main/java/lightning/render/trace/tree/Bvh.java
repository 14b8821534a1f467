package lightning.render.trace.tree;

import java.util.stream.IntStream;
import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.primitive.PrimitiveTable;
import org.jspecify.annotations.Nullable;

/**
 * Binary BVH over the primitives as flat arrays, one primitive per leaf.
 *
 * <p>A child is the index of an inner node or, if negative, the complement of a primitive. Node {@code n} has the children
 * {@code child[2 n]} and {@code child[2 n + 1]}, their boxes in {@code boxes[12 n …]}, six floats each, and in {@code axis[n]}
 * the axis along which the first child comes before the second. The root is node 0; there are no nodes for fewer than two
 * primitives.
 */
public final class Bvh {
    /** Growth of the total box area above which the BVH is rebuilt. */
    private static final double REBUILD_RATIO = 1.25;

    public final PrimitiveTable primitives;
    /** Start of each primitive's box in {@link #boxes}; a single primitive has the only box. */
    public final int[] leafBox;
    public final int[] child;
    public final float[] boxes;
    public final byte[] axis;
    /** Upper bound of the stack size: one child of every node on a path is pushed. */
    public final int depth;
    /** Total area of all boxes when the topology was built. */
    private final double builtArea;
    /** Primitives in it, ascending; null for all. */
    private final int @Nullable [] members;

    public Bvh(PrimitiveTable.BoxedPrimitives boxed) {
        primitives = boxed.primitives();
        members = null;
        BvhBuilder built = new BvhBuilder(boxed.boxes());
        child = built.child;
        boxes = primitives.count == 1 ? boxed.boxes() : built.boxes;
        axis = built.axis;
        depth = built.depth;
        leafBox = new int[primitives.count];
        for (int c = 0; c < child.length; c++) {
            if (child[c] < 0) {
                leafBox[~child[c]] = 6 * c;
            }
        }
        builtArea = totalArea();
    }

    /** Refits the topology of another BVH to the same primitives seen from another camera position. */
    public Bvh(PrimitiveTable.BoxedPrimitives boxed, Bvh topology) {
        primitives = boxed.primitives();
        members = topology.members;
        child = topology.child;
        leafBox = topology.leafBox;
        axis = topology.axis;
        depth = topology.depth;
        builtArea = topology.builtArea;
        boxes = primitives.count == 1 ? boxed.boxes() : new float[topology.boxes.length];
        // Children come after their node, so going backward all children are complete.
        for (int c = child.length - 1; c >= 0; c--) {
            if (child[c] < 0) {
                System.arraycopy(boxed.boxes(), 6 * ~child[c], boxes, 6 * c, 6);
            } else {
                encloseChildren(c);
            }
        }
    }

    /**
     * Refits a BVH to changed primitives in the same order, or rebuilds it. Rebuilds if their number differs, or if the boxes
     * grew so much that slower traversal costs more than a rebuild.
     */
    public static Bvh refitOrRebuild(PrimitiveTable.BoxedPrimitives boxed, Bvh topology) {
        if (boxed.primitives().count != topology.primitives.count) {
            return new Bvh(boxed);
        }
        Bvh refitted = new Bvh(boxed, topology);
        return refitted.totalArea() <= REBUILD_RATIO * topology.builtArea ? refitted : new Bvh(boxed);
    }

    /** Creates the BVH of selected primitives of another, with its boxes, in the order of its nodes. */
    private Bvh(Bvh source, boolean[] selected) {
        primitives = source.primitives;
        depth = source.depth;
        builtArea = source.builtArea;
        members = IntStream.range(0, selected.length).filter(s -> selected[s]).toArray();
        if (members.length == 0) {
            child = new int[0];
            boxes = new float[0];
            axis = new byte[0];
            leafBox = new int[primitives.count];
            return;
        }
        int[] selectedBelow = new int[source.axis.length];
        int count = 0;
        // Children come after their node.
        for (int c = source.child.length - 1; c >= 0; c--) {
            int selectedCount = source.child[c] < 0 ? selected[~source.child[c]] ? 1 : 0 : selectedBelow[source.child[c]];
            selectedBelow[c / 2] += selectedCount;
            count += source.child[c] < 0 ? selectedCount : 0;
        }
        int inner = Math.max(1, count - 1);
        child = new int[2 * inner];
        boxes = new float[12 * inner];
        axis = new byte[inner];
        leafBox = new int[primitives.count];
        int root = copySelected(source, selectedBelow, selected, 0, new int[1]);
        if (root < 0) {
            // A single remaining primitive becomes both children of the root.
            child[0] = root;
            child[1] = root;
        }
        for (int c = child.length - 1; c >= 0; c--) {
            if (child[c] < 0) {
                leafBox[~child[c]] = 6 * c;
                System.arraycopy(source.boxes, source.leafBox[~child[c]], boxes, 6 * c, 6);
            } else {
                encloseChildren(c);
            }
        }
    }

    /** Sets the box of an inner child to that of both children of its node. */
    private void encloseChildren(int c) {
        BvhBuilder.setEmpty(boxes, 6 * c);
        BvhBuilder.grow(boxes, 6 * c, boxes, 12 * child[c]);
        BvhBuilder.grow(boxes, 6 * c, boxes, 12 * child[c] + 6);
    }

    /**
     * Copies the selected primitives below a child of another BVH's node; there must be at least one.
     *
     * @param selectedBelow number of selected primitives below each node of the source
     * @param nodeCount number of nodes so far, {@code int[1]}
     * @return the copied child
     */
    private int copySelected(Bvh source, int[] selectedBelow, boolean[] selected, int from, int[] nodeCount) {
        int at = from;
        // Skip nodes with selected primitives on only one side.
        while (at >= 0) {
            int left = source.child[2 * at];
            int right = source.child[2 * at + 1];
            if (hasSelected(left, selectedBelow, selected) && hasSelected(right, selectedBelow, selected)) {
                int node = nodeCount[0]++;
                axis[node] = source.axis[at];
                child[2 * node] = copySelected(source, selectedBelow, selected, left, nodeCount);
                child[2 * node + 1] = copySelected(source, selectedBelow, selected, right, nodeCount);
                return node;
            }
            at = hasSelected(left, selectedBelow, selected) ? left : right;
        }
        return at;
    }

    private static boolean hasSelected(int child, int[] selectedBelow, boolean[] selected) {
        return child < 0 ? selected[~child] : selectedBelow[child] > 0;
    }

    /**
     * Returns a BVH over some of the primitives; their indices and boxes stay.
     *
     * @param selected flag for each primitive
     */
    public Bvh subset(boolean[] selected) {
        return primitives.count == 1 && selected[0] ? this : new Bvh(this, selected);
    }

    /** Returns the number of primitives in it. */
    public int size() {
        return members == null ? primitives.count : members.length;
    }

    /** Returns the index of a primitive in it, ascending from 0 … {@link #size} − 1. */
    public int member(int i) {
        return members == null ? i : members[i];
    }

    private double totalArea() {
        double size = 0;
        for (int c = 0; c < child.length; c++) {
            size += BvhBuilder.area(boxes, 6 * c);
        }
        return size;
    }

    /** Returns the primitive that a ray hits first, the one with the lowest index among equal distances, or −1. */
    public int nearest(Ray ray) {
        return traversal(ray).nearest();
    }

    /** Returns whether a ray hits any primitive at a distance below {@code limit}. */
    public boolean isBlocked(Ray ray, double limit) {
        return traversal(ray).isBlocked(limit);
    }

    /**
     * Returns the primitive that a shadow ray hits first before its end, the one with the lowest index among equal distances,
     * or −1.
     */
    public int blocker(Ray shadowRay, ShadowRayTarget target) {
        RayTraversal traversal = traversal(shadowRay);
        traversal.setTarget(target);
        return traversal.nearest(1);
    }

    /** Returns a traversal for a ray. */
    public RayTraversal traversal(Ray ray) {
        Vec3 o = ray.origin();
        Vec3 d = ray.direction();
        RayTraversal traversal = new RayTraversal(this);
        traversal.setRay(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
        return traversal;
    }
}
