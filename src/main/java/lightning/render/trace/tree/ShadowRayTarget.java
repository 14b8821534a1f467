package lightning.render.trace.tree;

import java.util.Arrays;
import java.util.function.IntPredicate;
import java.util.function.IntUnaryOperator;
import lightning.base.math.Vec3;
import lightning.render.trace.primitive.PrimitiveTable;

/**
 * Where ways to a light end: a point, and the primitives on which it lies, as far as rounding can tell.
 *
 * <p>A light that was put on a surface lies on either side of it by rounding, and rays that come from far are less exact than
 * such that come from near. So each primitive is noted with the distance from the camera from which on a row cannot tell.
 */
public final class ShadowRayTarget {
    /** A way that ends on no primitive, or never. */
    public static final ShadowRayTarget OFF_SURFACE = new ShadowRayTarget(Vec3.ZERO, new int[0], new double[0]);

    private final Vec3 point;
    /** The primitives, ascending. */
    private final int[] primitive;
    /** A row's |x| + |y| + |z| from which on the light lies on the primitive, render space. */
    private final double[] minRowDistance;

    private ShadowRayTarget(Vec3 point, int[] primitive, double[] minRowDistance) {
        this.point = point;
        this.primitive = primitive;
        this.minRowDistance = minRowDistance;
    }

    /**
     * The end of ways to a point in render space.
     *
     * <p>It lies on a primitive if it is no farther off than {@link PrimitiveTable#lightTolerance} and a row tell: neither off the
     * surface nor off the box around it, whichever shows it. The tree leads to the primitives by boxes that are wider for all by
     * what any of them may be off.
     */
    public static ShadowRayTarget find(Vec3 point, Bvh bvh) {
        PrimitiveTable primitives = bvh.primitives;
        double margin = primitives.lightTolerance(absSum(point)) + PrimitiveTable.SHADOW_RAY_ERROR * primitives.maxCoordinateSum;
        int[] candidates = new int[8];
        int count = 0;
        int[] stack = new int[bvh.depth + 2];
        int top = 0;
        if (primitives.count > 0) {
            stack[top++] = primitives.count == 1 ? ~0 : 0;
        }
        while (top > 0) {
            int next = stack[--top];
            if (next < 0) {
                candidates = count == candidates.length ? Arrays.copyOf(candidates, 2 * count) : candidates;
                candidates[count++] = ~next;
                continue;
            }
            for (int c = 0; c < 2; c++) {
                if (contains(bvh.boxes, 12 * next + 6 * c, point, margin)) {
                    stack[top++] = bvh.child[2 * next + c];
                }
            }
        }
        Arrays.sort(candidates, 0, count);
        return findAmong(candidates, count, point, bvh);
    }

    /** The same; every primitive is asked. */
    public static ShadowRayTarget findBruteForce(Vec3 point, Bvh bvh) {
        int[] candidates = new int[bvh.primitives.count];
        Arrays.setAll(candidates, s -> s);
        return findAmong(candidates, candidates.length, point, bvh);
    }

    /** @param candidates ascending; the primitives on which the point may lie, {@code asked[0 … count − 1]} */
    private static ShadowRayTarget findAmong(int[] candidates, int count, Vec3 point, Bvh bvh) {
        PrimitiveTable primitives = bvh.primitives;
        int[] primitive = new int[count];
        double[] minRowDistance = new double[count];
        int found = 0;
        for (int i = 0; i < count; i++) {
            int s = candidates[i];
            double tolerance = primitives.lightTolerance(s, absSum(point));
            double minDistance =
                    (primitives.surfaceDistance(s, point.x(), point.y(), point.z()) - tolerance) / PrimitiveTable.SHADOW_RAY_ERROR;
            if (minDistance <= primitives.maxCoordinateSum && contains(bvh.boxes, bvh.leafBox[s], point,
                    tolerance + PrimitiveTable.SHADOW_RAY_ERROR * primitives.maxCoordinateSum)) {
                primitive[found] = s;
                minRowDistance[found++] = minDistance;
            }
        }
        return found == 0 ? new ShadowRayTarget(point, OFF_SURFACE.primitive, OFF_SURFACE.minRowDistance)
                : new ShadowRayTarget(point, Arrays.copyOf(primitive, found), Arrays.copyOf(minRowDistance, found));
    }

    private static double absSum(Vec3 point) {
        return Math.abs(point.x()) + Math.abs(point.y()) + Math.abs(point.z());
    }

    /** Whether a point lies in the box {@code boxes[at … at + 5]}, or off it by no more than the margin on each axis. */
    private static boolean contains(float[] boxes, int at, Vec3 p, double margin) {
        return p.x() >= boxes[at] - margin && p.x() <= boxes[at + 3] + margin
                && p.y() >= boxes[at + 1] - margin && p.y() <= boxes[at + 4] + margin
                && p.z() >= boxes[at + 2] - margin && p.z() <= boxes[at + 5] + margin;
    }

    /**
     * Whether the primitives that are the same before and after a change are the same here and in {@code after}.
     *
     * @param newIndex of a primitive of before the index that it has after; negative where it is not the same
     * @param existedBefore whether a primitive of after was there before
     */
    public boolean hasSameContacts(ShadowRayTarget after, IntUnaryOperator newIndex, IntPredicate existedBefore) {
        int common = 0;
        for (int i = 0; i < primitive.length; i++) {
            int moved = newIndex.applyAsInt(primitive[i]);
            if (moved >= 0) {
                int index = after.indexOf(moved);
                if (index < 0 || after.minRowDistance[index] != minRowDistance[i]) {
                    return false;
                }
                common++;
            }
        }
        return common == Arrays.stream(after.primitive).filter(existedBefore).count();
    }

    /** The point, render space. */
    public Vec3 point() {
        return point;
    }

    /** Whether it lies on no primitive. */
    public boolean isOffSurface() {
        return primitive.length == 0;
    }

    /** The index of a primitive for {@link #touches(int, double, double, double)}, negative where the light is not on it. */
    public int indexOf(int s) {
        return primitive.length == 0 ? -1 : Arrays.binarySearch(primitive, s);
    }

    /** Whether, for a row at a point in render space, the light lies on the primitive of an index. */
    public boolean touches(int index, double x, double y, double z) {
        return Math.abs(x) + Math.abs(y) + Math.abs(z) >= minRowDistance[index];
    }

    /** Whether, for a row at a point in render space, the light lies on primitive {@code s}. */
    public boolean touches(int s, Vec3 row) {
        int index = indexOf(s);
        return index >= 0 && touches(index, row.x(), row.y(), row.z());
    }
}
