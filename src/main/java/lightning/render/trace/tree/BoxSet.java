package lightning.render.trace.tree;

import java.util.Arrays;
import lightning.render.trace.primitive.PrimitiveBoxes;

/**
 * The padded boxes of some primitives: whether a ray, or any of a bundle, can meet one of them. Immutable.
 *
 * <p>It rejects as the tree does, by the same boxes and the same tests: what is not touched here would not have been asked there,
 * and would not have been met ({@link PrimitiveBoxes}).
 */
public final class BoxSet {
    public static final BoxSet NONE = new BoxSet(new float[0]);
    /** So many boxes lie in one around them, which is asked first. */
    private static final int TOGETHER = 16;

    private final float[] boxes;
    private final float[] around;

    /** @param boxes {@code float[6 * count]}: min x y z, max x y z of each */
    private BoxSet(float[] boxes) {
        this.boxes = boxes;
        around = new float[(boxes.length / 6 + TOGETHER - 1) / TOGETHER * 6];
        for (int a = 0; a < around.length; a += 6) {
            BvhBuilder.empty(around, a);
            for (int i = a * TOGETHER; i < end(a); i += 6) {
                BvhBuilder.grow(around, a, boxes, i);
            }
        }
    }

    /** The boxes of some primitives of a tree. */
    public static BoxSet of(Bvh bvh, int[] primitives, int count) {
        float[] boxes = new float[6 * count];
        for (int i = 0; i < count; i++) {
            System.arraycopy(bvh.boxes, bvh.leaf[primitives[i]], boxes, 6 * i, 6);
        }
        return count == 0 ? NONE : new BoxSet(boxes);
    }

    /** Of this one's boxes and those of another. */
    public BoxSet and(BoxSet o) {
        float[] all = Arrays.copyOf(boxes, boxes.length + o.boxes.length);
        System.arraycopy(o.boxes, 0, all, boxes.length, o.boxes.length);
        return new BoxSet(all);
    }

    public boolean isEmpty() {
        return boxes.length == 0;
    }

    /** Whether any ray of a bundle can meet any of the boxes. */
    public boolean touches(Beam beam) {
        for (int a = 0; a < around.length; a += 6) {
            if (beam.touches(around, a) < Double.POSITIVE_INFINITY) {
                for (int i = a * TOGETHER; i < end(a); i += 6) {
                    if (beam.touches(boxes, i) < Double.POSITIVE_INFINITY) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    /** Whether a ray can meet any of the boxes at a distance up to {@code limit}. */
    public boolean touches(BoxRay ray, double limit) {
        for (int a = 0; a < around.length; a += 6) {
            if (ray.hits(around, a, limit)) {
                for (int i = a * TOGETHER; i < end(a); i += 6) {
                    if (ray.hits(boxes, i, limit)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    private int end(int around) {
        return Math.min(boxes.length, (around + 6) * TOGETHER);
    }
}
