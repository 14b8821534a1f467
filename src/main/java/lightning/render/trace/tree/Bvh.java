package lightning.render.trace.tree;

import lightning.base.math.Ray;
import lightning.base.math.Vec3;
import lightning.render.trace.primitive.PrimitiveTable;

/**
 * A binary tree of boxes over the primitives, one primitive in each leaf, as plain arrays.
 *
 * <p>A child is the index of an inner node or, where negative, the complement of a primitive. Node {@code n}
 * has the children {@code child[2 n]} and {@code child[2 n + 1]}, their boxes in
 * {@code boxes[12 n …]}, six floats each, and the axis along which the first lies before the second in
 * {@code axis[n]}. The root is node 0; there is no node where there are fewer than two primitives.
 */
public final class Bvh {
    /** A tree whose boxes are larger together than this times what they were is built anew. */
    private static final double REBUILD_RATIO = 1.25;

    public final PrimitiveTable primitives;
    /** Where the box of each primitive begins in {@link #boxes}; one that is alone has the only one there. */
    public final int[] leafBox;
    public final int[] child;
    public final float[] boxes;
    public final byte[] axis;
    /** Pushed at most this many at a time when one child of every node is put aside. */
    public final int depth;
    /** How large all boxes were together, each as an area, when the form of the tree was found. */
    private final double builtArea;

    public Bvh(PrimitiveTable.BoxedPrimitives boxed) {
        primitives = boxed.primitives();
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

    /** The tree of the same primitives seen from elsewhere: its form with their boxes. */
    public Bvh(PrimitiveTable.BoxedPrimitives boxed, Bvh topology) {
        primitives = boxed.primitives();
        child = topology.child;
        leafBox = topology.leafBox;
        axis = topology.axis;
        depth = topology.depth;
        builtArea = topology.builtArea;
        boxes = primitives.count == 1 ? boxed.boxes() : new float[topology.boxes.length];
        // Children come after their node, so that from the last on all are there.
        for (int c = child.length - 1; c >= 0; c--) {
            if (child[c] < 0) {
                System.arraycopy(boxed.boxes(), 6 * ~child[c], boxes, 6 * c, 6);
            } else {
                BvhBuilder.setEmpty(boxes, 6 * c);
                BvhBuilder.grow(boxes, 6 * c, boxes, 12 * child[c]);
                BvhBuilder.grow(boxes, 6 * c, boxes, 12 * child[c] + 6);
            }
        }
    }

    /**
     * A tree over primitives that follow from those of another, in the same order: its form with their boxes, or a form of their own
     * where there are more or fewer, or where boxes became so large that rays would find them more slowly than a new form takes.
     */
    public static Bvh refitOrRebuild(PrimitiveTable.BoxedPrimitives boxed, Bvh topology) {
        if (boxed.primitives().count != topology.primitives.count) {
            return new Bvh(boxed);
        }
        Bvh refitted = new Bvh(boxed, topology);
        return refitted.totalArea() <= REBUILD_RATIO * topology.builtArea ? refitted : new Bvh(boxed);
    }

    /** A tree of those primitives of another that are kept, with its boxes, in the order of its nodes; at least one is kept. */
    private Bvh(Bvh source, boolean[] selected) {
        primitives = source.primitives;
        depth = source.depth;
        builtArea = source.builtArea;
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
            // One that is left alone is both children of the root.
            child[0] = root;
            child[1] = root;
        }
        for (int c = child.length - 1; c >= 0; c--) {
            if (child[c] < 0) {
                leafBox[~child[c]] = 6 * c;
                System.arraycopy(source.boxes, source.leafBox[~child[c]], boxes, 6 * c, 6);
            } else {
                BvhBuilder.setEmpty(boxes, 6 * c);
                BvhBuilder.grow(boxes, 6 * c, boxes, 12 * child[c]);
                BvhBuilder.grow(boxes, 6 * c, boxes, 12 * child[c] + 6);
            }
        }
    }

    /**
     * Keeps what is below a child of a node of another tree that has anything to keep.
     *
     * @param selectedBelow of each node of it how many primitives are kept
     * @param nodeCount how many nodes there are here, {@code int[1]}
     * @return what stands for it here
     */
    private int copySelected(Bvh source, int[] selectedBelow, boolean[] selected, int from, int[] nodeCount) {
        int at = from;
        // Of a node with one side alone that side stands in its place.
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
     * The tree that finds the same primitives but those that are left out; their indices and boxes stay.
     *
     * @param selected for each primitive whether it is kept: at least one is
     */
    public Bvh subset(boolean[] selected) {
        return primitives.count == 1 ? this : new Bvh(this, selected);
    }

    private double totalArea() {
        double size = 0;
        for (int c = 0; c < child.length; c++) {
            size += BvhBuilder.area(boxes, 6 * c);
        }
        return size;
    }

    /** The primitive that a ray meets first, the one with the lowest index among equals, or −1. */
    public int nearest(Ray ray) {
        return traversal(ray).nearest();
    }

    /** Whether a ray meets any primitive at a distance below {@code limit}. */
    public boolean isBlocked(Ray ray, double limit) {
        return traversal(ray).isBlocked(limit);
    }

    /** The primitive that a way to a light meets first before its end, the one with the lowest index among equals, or −1. */
    public int blocker(Ray shadowRay, ShadowRayTarget target) {
        RayTraversal traversal = traversal(shadowRay);
        traversal.setTarget(target);
        return traversal.nearest(1);
    }

    /** A walk that has taken a ray. */
    public RayTraversal traversal(Ray ray) {
        Vec3 o = ray.origin();
        Vec3 d = ray.direction();
        RayTraversal traversal = new RayTraversal(this);
        traversal.setRay(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
        return traversal;
    }
}
