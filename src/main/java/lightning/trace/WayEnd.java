package lightning.trace;

import java.util.Arrays;
import lightning.math.Vec3;

/**
 * Where ways to a light end: a point, and the primitives on which it lies, as far as rounding can tell.
 *
 * <p>A light that was put on a surface lies on either side of it by rounding, and rays that come from far are less exact than
 * such that come from near. So each primitive is noted with the distance from the camera from which on a row cannot tell.
 */
public final class WayEnd {
    /** A way that ends on no primitive, or never. */
    public static final WayEnd OPEN = new WayEnd(Vec3.ZERO, new int[0], new double[0]);

    private final Vec3 point;
    /** The primitives, ascending. */
    private final int[] primitive;
    /** A row's |x| + |y| + |z| from which on the light lies on the primitive, render space. */
    private final double[] from;

    private WayEnd(Vec3 point, int[] primitive, double[] from) {
        this.point = point;
        this.primitive = primitive;
        this.from = from;
    }

    /** The end of ways to a point in render space. */
    static WayEnd at(Vec3 point, PrimitiveTable primitives) {
        int[] primitive = new int[4];
        double[] from = new double[4];
        int count = 0;
        double far = Math.abs(point.x()) + Math.abs(point.y()) + Math.abs(point.z());
        for (int s = 0; s < primitives.count; s++) {
            double lies = (primitives.gap(s, point.x(), point.y(), point.z()) - primitives.offLight(s, far)) / PrimitiveTable.WAY;
            if (lies <= primitives.reach) {
                if (count == primitive.length) {
                    primitive = Arrays.copyOf(primitive, 2 * count);
                    from = Arrays.copyOf(from, 2 * count);
                }
                primitive[count] = s;
                from[count++] = lies;
            }
        }
        return count == 0 ? new WayEnd(point, OPEN.primitive, OPEN.from)
                : new WayEnd(point, Arrays.copyOf(primitive, count), Arrays.copyOf(from, count));
    }

    /** The point, render space. */
    public Vec3 point() {
        return point;
    }

    /** The index of a primitive for {@link #touches(int, double, double, double)}, negative where the light is not on it. */
    int indexOf(int s) {
        return primitive.length == 0 ? -1 : Arrays.binarySearch(primitive, s);
    }

    /** Whether, for a row at a point in render space, the light lies on the primitive of an index. */
    boolean touches(int index, double x, double y, double z) {
        return Math.abs(x) + Math.abs(y) + Math.abs(z) >= from[index];
    }

    /** Whether, for a row at a point in render space, the light lies on primitive {@code s}. */
    boolean touches(int s, Vec3 row) {
        int index = indexOf(s);
        return index >= 0 && touches(index, row.x(), row.y(), row.z());
    }
}
