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
    private static final double WORN = 1.25;

    public final PrimitiveTable primitives;
    /** Where the box of each primitive begins in {@link #boxes}; one that is alone has the only one there. */
    public final int[] leaf;
    public final int[] child;
    public final float[] boxes;
    public final byte[] axis;
    /** Pushed at most this many at a time when one child of every node is put aside. */
    public final int depth;
    /** How large all boxes were together, each as an area, when the form of the tree was found. */
    private final double found;

    public Bvh(PrimitiveTable.Boxed boxed) {
        primitives = boxed.primitives();
        BvhBuilder built = new BvhBuilder(boxed.boxes());
        child = built.child;
        boxes = primitives.count == 1 ? boxed.boxes() : built.boxes;
        axis = built.axis;
        depth = built.depth;
        leaf = new int[primitives.count];
        for (int c = 0; c < child.length; c++) {
            if (child[c] < 0) {
                leaf[~child[c]] = 6 * c;
            }
        }
        found = size();
    }

    /** The tree of the same primitives seen from elsewhere: its form with their boxes. */
    public Bvh(PrimitiveTable.Boxed boxed, Bvh form) {
        primitives = boxed.primitives();
        child = form.child;
        leaf = form.leaf;
        axis = form.axis;
        depth = form.depth;
        found = form.found;
        boxes = primitives.count == 1 ? boxed.boxes() : new float[form.boxes.length];
        // Children come after their node, so that from the last on all are there.
        for (int c = child.length - 1; c >= 0; c--) {
            if (child[c] < 0) {
                System.arraycopy(boxed.boxes(), 6 * ~child[c], boxes, 6 * c, 6);
            } else {
                BvhBuilder.empty(boxes, 6 * c);
                BvhBuilder.grow(boxes, 6 * c, boxes, 12 * child[c]);
                BvhBuilder.grow(boxes, 6 * c, boxes, 12 * child[c] + 6);
            }
        }
    }

    /**
     * A tree over primitives that follow from those of another, in the same order: its form with their boxes, or a form of their own
     * where there are more or fewer, or where boxes became so large that rays would find them more slowly than a new form takes.
     */
    public static Bvh following(PrimitiveTable.Boxed boxed, Bvh form) {
        if (boxed.primitives().count != form.primitives.count) {
            return new Bvh(boxed);
        }
        Bvh moved = new Bvh(boxed, form);
        return moved.size() <= WORN * form.found ? moved : new Bvh(boxed);
    }

    /** A tree of those primitives of another that are kept, with its boxes, in the order of its nodes; at least one is kept. */
    private Bvh(Bvh all, boolean[] kept) {
        primitives = all.primitives;
        depth = all.depth;
        found = all.found;
        int[] below = new int[all.axis.length];
        int count = 0;
        // Children come after their node.
        for (int c = all.child.length - 1; c >= 0; c--) {
            int here = all.child[c] < 0 ? kept[~all.child[c]] ? 1 : 0 : below[all.child[c]];
            below[c / 2] += here;
            count += all.child[c] < 0 ? here : 0;
        }
        int inner = Math.max(1, count - 1);
        child = new int[2 * inner];
        boxes = new float[12 * inner];
        axis = new byte[inner];
        leaf = new int[primitives.count];
        int only = keep(all, below, kept, 0, new int[1]);
        if (only < 0) {
            // One that is left alone is both children of the root.
            child[0] = only;
            child[1] = only;
        }
        for (int c = child.length - 1; c >= 0; c--) {
            if (child[c] < 0) {
                leaf[~child[c]] = 6 * c;
                System.arraycopy(all.boxes, all.leaf[~child[c]], boxes, 6 * c, 6);
            } else {
                BvhBuilder.empty(boxes, 6 * c);
                BvhBuilder.grow(boxes, 6 * c, boxes, 12 * child[c]);
                BvhBuilder.grow(boxes, 6 * c, boxes, 12 * child[c] + 6);
            }
        }
    }

    /**
     * Keeps what is below a child of a node of another tree that has anything to keep.
     *
     * @param below of each node of it how many primitives are kept
     * @param nodes how many nodes there are here, {@code int[1]}
     * @return what stands for it here
     */
    private int keep(Bvh all, int[] below, boolean[] kept, int from, int[] nodes) {
        int at = from;
        // Of a node with one side alone that side stands in its place.
        while (at >= 0) {
            int left = all.child[2 * at];
            int right = all.child[2 * at + 1];
            if (isKept(left, below, kept) && isKept(right, below, kept)) {
                int node = nodes[0]++;
                axis[node] = all.axis[at];
                child[2 * node] = keep(all, below, kept, left, nodes);
                child[2 * node + 1] = keep(all, below, kept, right, nodes);
                return node;
            }
            at = isKept(left, below, kept) ? left : right;
        }
        return at;
    }

    private static boolean isKept(int child, int[] below, boolean[] kept) {
        return child < 0 ? kept[~child] : below[child] > 0;
    }

    /**
     * The tree that finds the same primitives but those that are left out; their indices and boxes stay.
     *
     * @param kept for each primitive whether it is kept: at least one is
     */
    public Bvh only(boolean[] kept) {
        return primitives.count == 1 ? this : new Bvh(this, kept);
    }

    private double size() {
        double size = 0;
        for (int c = 0; c < child.length; c++) {
            size += BvhBuilder.area(boxes, 6 * c);
        }
        return size;
    }

    /** The primitive that a ray meets first, the one with the lowest index among equals, or −1. */
    public int nearest(Ray ray) {
        return walk(ray).nearest();
    }

    /** Whether a ray meets any primitive at a distance below {@code limit}. */
    public boolean blocked(Ray ray, double limit) {
        return walk(ray).blocked(limit);
    }

    /** The primitive that a way to a light meets first before its end, the one with the lowest index among equals, or −1. */
    public int blocker(Ray way, WayEnd end) {
        RayWalk walk = walk(way);
        walk.leadTo(end);
        return walk.nearest(1);
    }

    /** A walk that has taken a ray. */
    public RayWalk walk(Ray ray) {
        Vec3 o = ray.origin();
        Vec3 d = ray.direction();
        RayWalk walk = new RayWalk(this);
        walk.enter(o.x(), o.y(), o.z(), d.x(), d.y(), d.z());
        return walk;
    }
}
