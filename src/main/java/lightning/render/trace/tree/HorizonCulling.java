package lightning.render.trace.tree;

import java.util.function.IntPredicate;
import lightning.base.Initializer;
import lightning.base.math.Vec3;
import lightning.render.trace.primitive.PrimitiveTable;

/**
 * Conservative culling of primitives that no shadow ray from a box of points can hit: they lie on one side of the box, and no
 * ray goes to that side. An example is the floor below points lit from above.
 *
 * <p>A culled primitive is certain to be missed, rounding included, without any margin. Rays compute local heights m₀·x + m₁·y
 * + m₂·z + m₃ of points, and those of directions without m₃; a direction is source − point. Rounded sums and products are
 * monotone in each operand (IEEE 754, §4.3). So the same operations in the same order, with the minimizing end of each axis,
 * give a lower bound for the whole box; the other ends give an upper bound.
 * {@link lightning.render.trace.solid.SolidGeometry#isCertainMiss} decides by these heights. If a sum is not finite, nothing is
 * culled. Reused; not thread-safe.
 */
public final class HorizonCulling {
    private PointBox box;
    private Vec3 low;
    private Vec3 high;
    private boolean endsAtPoints;
    private IntPredicate canHoldEnd;
    private double min;
    private double max;

    /**
     * Sets the shadow rays.
     *
     * @param points bounds of their origins
     * @param min minimum coordinates of their end points, or of their directions; render space
     * @param max maximum coordinates of their end points, or of their directions; render space
     * @param toPoints true for end points, false for directions
     * @param canHoldEnd primitives that may contain such an end point
     */
    @Initializer
    public void setRays(PointBox points, Vec3 min, Vec3 max, boolean toPoints, IntPredicate canHoldEnd) {
        box = points;
        low = min;
        high = max;
        endsAtPoints = toPoints;
        this.canHoldEnd = canHoldEnd;
    }

    /**
     * Returns true if certainly no shadow ray hits primitive {@code s}; false for a mesh and for primitives that contact the
     * eye or the light.
     */
    boolean isCulled(PrimitiveTable primitives, int s) {
        if (primitives.mesh(s) != null || primitives.isEyeOnSurface(s) || canHoldEnd.test(s)) {
            return false;
        }
        double[] m = primitives.data;
        int i = primitives.dataStart[s] + 4;
        resetSums();
        addTerm(m[i], box.low(0), box.high(0));
        addTerm(m[i + 1], box.low(1), box.high(1));
        addTerm(m[i + 2], box.low(2), box.high(2));
        double lowest = min + m[i + 3];
        double highest = max + m[i + 3];
        resetSums();
        addDirectionTerm(m[i], low.x(), high.x(), 0);
        addDirectionTerm(m[i + 1], low.y(), high.y(), 1);
        addDirectionTerm(m[i + 2], low.z(), high.z(), 2);
        return Double.isFinite(highest - lowest) && Double.isFinite(max - min)
                && primitives.kind(s).geometry().isCertainMiss(lowest, highest, min, max);
    }

    /** Resets the sums to −0, the neutral element of addition. */
    private void resetSums() {
        min = -0.0;
        max = -0.0;
    }

    private void addDirectionTerm(double m, double from, double to, int axis) {
        addTerm(m, endsAtPoints ? from - box.high(axis) : from, endsAtPoints ? to - box.low(axis) : to);
    }

    private void addTerm(double m, double from, double to) {
        double a = m * from;
        double b = m * to;
        min += Math.min(a, b);
        max += Math.max(a, b);
    }
}
