package lightning.render.trace.tree;

import java.util.function.IntPredicate;
import lightning.base.math.Vec3;
import lightning.render.trace.primitive.PrimitiveTable;

/**
 * Ways from the points of a box to a light or to places on it, and which primitives they certainly leave behind: those that lie on one side of the box
 * while no way turns to that side, as the floor on which points lie lies below a lamp above it.
 *
 * <p>Certain means that the distance which rays compute is a miss, roundings included. No margin is needed. Rays map a point to the
 * own height m₀·x + m₁·y + m₂·z + m₃ and a direction likewise, without the last; a direction is source − point, and both lie in boxes. All of it are
 * rounded sums and products, and a rounded sum or product by a constant never falls where the exact one rises (IEEE 754, §4.3:
 * rounding keeps order). So the same operations in the same order, done with the end of each axis that makes the result
 * least, give no more than the height of any point of the box; done with the other ends, no less. What follows from heights,
 * {@link lightning.render.trace.solid.SolidGeometry#isCertainMiss} tells. Where a sum is not finite nothing is certain. Reused; not shared between threads.
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
     * Takes ways.
     *
     * @param points     where they begin
     * @param min      the least coordinates of the points where they end, or of their directions; render space
     * @param max       the greatest
     * @param toPoints   which of both
     * @param canHoldEnd whether such a point may lie on a primitive
     */
    public void setRays(PointBox points, Vec3 min, Vec3 max, boolean toPoints, IntPredicate canHoldEnd) {
        box = points;
        low = min;
        high = max;
        endsAtPoints = toPoints;
        this.canHoldEnd = canHoldEnd;
    }

    /** Whether no way meets primitive {@code s}, for certain; false for a mesh, and for what eye or light lie on. */
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

    /** The sums begin with −0, to which anything may be added. */
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
