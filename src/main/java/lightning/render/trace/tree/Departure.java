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
 * {@link lightning.render.trace.solid.Form#isPassed} tells. Where a sum is not finite nothing is certain. Reused; not shared between threads.
 */
public final class Departure {
    private PointBox box;
    private Vec3 low;
    private Vec3 high;
    private boolean ends;
    private IntPredicate isUnderEnd;
    private double least;
    private double most;

    /**
     * Takes ways.
     *
     * @param points     where they begin
     * @param least      the least coordinates of the points where they end, or of their directions; render space
     * @param most       the greatest
     * @param toPoints   which of both
     * @param isUnderEnd whether such a point may lie on a primitive
     */
    public void take(PointBox points, Vec3 least, Vec3 most, boolean toPoints, IntPredicate isUnderEnd) {
        box = points;
        low = least;
        high = most;
        ends = toPoints;
        this.isUnderEnd = isUnderEnd;
    }

    /** Whether no way meets primitive {@code s}, for certain; false for a mesh, and for what eye or light lie on. */
    boolean leaves(PrimitiveTable primitives, int s) {
        if (primitives.mesh(s) != null || primitives.isUnderEye(s) || isUnderEnd.test(s)) {
            return false;
        }
        double[] m = primitives.data;
        int i = primitives.at[s] + 4;
        begin();
        axis(m[i], box.low(0), box.high(0));
        axis(m[i + 1], box.low(1), box.high(1));
        axis(m[i + 2], box.low(2), box.high(2));
        double lowest = least + m[i + 3];
        double highest = most + m[i + 3];
        begin();
        direction(m[i], low.x(), high.x(), 0);
        direction(m[i + 1], low.y(), high.y(), 1);
        direction(m[i + 2], low.z(), high.z(), 2);
        return Double.isFinite(highest - lowest) && Double.isFinite(most - least)
                && primitives.kind(s).form().isPassed(lowest, highest, least, most);
    }

    /** The sums begin with −0, to which anything may be added. */
    private void begin() {
        least = -0.0;
        most = -0.0;
    }

    private void direction(double m, double from, double to, int axis) {
        axis(m, ends ? from - box.high(axis) : from, ends ? to - box.low(axis) : to);
    }

    private void axis(double m, double from, double to) {
        double a = m * from;
        double b = m * to;
        least += Math.min(a, b);
        most += Math.max(a, b);
    }
}
