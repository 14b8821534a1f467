package lightning.render.trace.tree;

import java.util.Arrays;
import java.util.function.IntPredicate;
import java.util.function.IntUnaryOperator;
import lightning.base.math.Vec3;
import lightning.render.trace.primitive.PrimitiveTable;

/**
 * End point of shadow rays to a light, with the primitives that contain it up to rounding.
 *
 * <p>A light placed on a surface is on either side of it by rounding, and rays from distant points are less exact. So each
 * primitive has a minimum row distance from the camera, from which on the side is undecidable.
 *
 * @param point          point, render space
 * @param primitive      primitives, ascending
 * @param minRowDistance minimum |x| + |y| + |z| of a row, render space, from which on the light counts as on the primitive
 */
public record ShadowRayTarget(Vec3 point, int[] primitive, double[] minRowDistance) {
    /** Target of shadow rays that end on no primitive, or are unbounded. */
    public static final ShadowRayTarget OFF_SURFACE = new ShadowRayTarget(Vec3.ZERO, new int[0], new double[0]);

    /**
     * Returns the target of shadow rays to a point in render space.
     *
     * <p>The point is on a primitive if its distance is at most {@link PrimitiveTable#lightTolerance} for the row, measured
     * both from the surface and from its box. The BVH finds these primitives with boxes padded by the largest tolerance of any
     * of them.
     */
    public static ShadowRayTarget find(Vec3 point, Bvh bvh) {
        PrimitiveTable primitives = bvh.primitives;
        double margin = primitives.lightTolerance(absSum(point)) + PrimitiveTable.SHADOW_RAY_ERROR * primitives.maxCoordinateSum;
        int[] candidates = new int[8];
        int count = 0;
        int[] stack = new int[bvh.depth + 2];
        int top = 0;
        if (bvh.size() > 0) {
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

    /** Returns the target of shadow rays to a point; tests every primitive. */
    public static ShadowRayTarget findBruteForce(Vec3 point, Bvh bvh) {
        int[] candidates = new int[bvh.size()];
        Arrays.setAll(candidates, bvh::member);
        return findAmong(candidates, candidates.length, point, bvh);
    }

    /** @param candidates ascending; the primitives that may contain the point, {@code candidates[0 … count − 1]} */
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

    /** Returns whether a point is in the box {@code boxes[at … at + 5]} or within a margin of it on each axis. */
    private static boolean contains(float[] boxes, int at, Vec3 p, double margin) {
        return p.x() >= boxes[at] - margin && p.x() <= boxes[at + 3] + margin
                && p.y() >= boxes[at + 1] - margin && p.y() <= boxes[at + 4] + margin
                && p.z() >= boxes[at + 2] - margin && p.z() <= boxes[at + 5] + margin;
    }

    /**
     * Returns whether this target and {@code after} touch the same unchanged primitives.
     *
     * @param newIndex maps old primitive indices to new ones; negative if removed or changed
     * @param existedBefore true for new primitives that existed before
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

    /** Returns whether the point is on no primitive. */
    public boolean isOffSurface() {
        return primitive.length == 0;
    }

    /** Returns the index of a primitive for {@link #touches(int, double, double, double)}; negative if the light is not on it. */
    public int indexOf(int s) {
        return primitive.length == 0 ? -1 : Arrays.binarySearch(primitive, s);
    }

    /** Returns whether the light is on the primitive of an index, for a row at a point in render space. */
    public boolean touches(int index, double x, double y, double z) {
        return Math.abs(x) + Math.abs(y) + Math.abs(z) >= minRowDistance[index];
    }

    /** Returns whether the light is on primitive {@code s}, for a row at a point in render space. */
    public boolean touches(int s, Vec3 row) {
        int index = indexOf(s);
        return index >= 0 && touches(index, row.x(), row.y(), row.z());
    }
}
