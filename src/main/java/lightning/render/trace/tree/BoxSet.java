package lightning.render.trace.tree;

import java.util.Arrays;
import lightning.render.trace.primitive.PrimitiveBoxes;

/**
 * Padded boxes of some primitives, for tests against a ray or a beam. Immutable.
 *
 * <p>The tests and the boxes are the same as in the BVH. So a ray rejected here would not reach these primitives there, and
 * would not hit them ({@link PrimitiveBoxes}).
 */
public final class BoxSet {
    public static final BoxSet NONE = new BoxSet(new float[0]);
    /** Number of boxes in one group, whose bounds are tested first. */
    private static final int GROUP_SIZE = 16;

    private final float[] boxes;
    private final float[] groupBoxes;

    /** @param boxes {@code float[6 * count]}: min x y z, max x y z of each */
    private BoxSet(float[] boxes) {
        this.boxes = boxes;
        groupBoxes = new float[(boxes.length / 6 + GROUP_SIZE - 1) / GROUP_SIZE * 6];
        for (int a = 0; a < groupBoxes.length; a += 6) {
            BvhBuilder.setEmpty(groupBoxes, a);
            for (int i = a * GROUP_SIZE; i < groupEnd(a); i += 6) {
                BvhBuilder.grow(groupBoxes, a, boxes, i);
            }
        }
    }

    /** Returns the boxes of some primitives of a BVH. */
    public static BoxSet of(Bvh bvh, int[] primitives, int count) {
        float[] boxes = new float[6 * count];
        for (int i = 0; i < count; i++) {
            System.arraycopy(bvh.boxes, bvh.leafBox[primitives[i]], boxes, 6 * i, 6);
        }
        return count == 0 ? NONE : new BoxSet(boxes);
    }

    /** Returns the union of these boxes and those of another set. */
    public BoxSet union(BoxSet other) {
        float[] merged = Arrays.copyOf(boxes, boxes.length + other.boxes.length);
        System.arraycopy(other.boxes, 0, merged, boxes.length, other.boxes.length);
        return new BoxSet(merged);
    }

    /** Returns the number of boxes. */
    public int count() {
        return boxes.length / 6;
    }

    public boolean isEmpty() {
        return boxes.length == 0;
    }

    /** Returns whether any ray of a beam can hit any of the boxes. */
    public boolean intersects(RayBeam beam) {
        for (int a = 0; a < groupBoxes.length; a += 6) {
            if (beam.entryTime(groupBoxes, a) < Double.POSITIVE_INFINITY) {
                for (int i = a * GROUP_SIZE; i < groupEnd(a); i += 6) {
                    if (beam.entryTime(boxes, i) < Double.POSITIVE_INFINITY) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    /** Returns whether a ray can hit any of the boxes at a distance up to {@code limit}. */
    public boolean intersects(BoxRay ray, double limit) {
        for (int a = 0; a < groupBoxes.length; a += 6) {
            if (ray.hits(groupBoxes, a, limit)) {
                for (int i = a * GROUP_SIZE; i < groupEnd(a); i += 6) {
                    if (ray.hits(boxes, i, limit)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    private int groupEnd(int group) {
        return Math.min(boxes.length, (group + 6) * GROUP_SIZE);
    }
}
