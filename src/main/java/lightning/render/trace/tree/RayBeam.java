package lightning.render.trace.tree;

import java.util.Arrays;
import lightning.base.math.Vec3;

/**
 * Volume swept by a bundle of rays, such as a tile's shadow rays to one light, its camera rays, or its reflected rays.
 *
 * <p>At time {@code t}, from 0 to {@code end}, every ray is in the box from {@code low + t·lowSpeed} to
 * {@code high + t·highSpeed}: a box of origins that moves, and grows or shrinks. Whether it ever touches a fixed box is a
 * system of six linear inequalities in t. The answer is exact for the convex hull of origins and light (as the shafts of Haines
 * and Wallace 1991, but without planes). Reused; not thread-safe.
 * <pre>{@code beam.clear(); beam.addOrigins(rows.bounds(tracer)); beam.aimAt(light); candidates.collect(geometry.bvh(), beam); }</pre>
 */
public final class RayBeam {
    /** Maximum time, slightly above 1 because rays reach their light only up to rounding. */
    private static final double MAX_TIME = 1 + 0x1p-20;

    private final double[] low = new double[3];
    private final double[] high = new double[3];
    private final double[] lowSpeed = new double[3];
    private final double[] highSpeed = new double[3];
    private double end;

    public RayBeam() {
        clear();
    }

    /** Removes all origins and directions. */
    public void clear() {
        Arrays.fill(low, Double.POSITIVE_INFINITY);
        Arrays.fill(high, Double.NEGATIVE_INFINITY);
        Arrays.fill(lowSpeed, Double.POSITIVE_INFINITY);
        Arrays.fill(highSpeed, Double.NEGATIVE_INFINITY);
        end = Double.POSITIVE_INFINITY;
    }

    /** Adds an origin, render space. */
    public void addOrigin(double x, double y, double z) {
        include(low, high, x, y, z);
    }

    /** Adds all origins in a box, render space. */
    public void addOrigins(PointBox box) {
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = Math.min(low[axis], box.low(axis));
            high[axis] = Math.max(high[axis], box.high(axis));
        }
    }

    /** Adds a direction of any length for unbounded rays. */
    public void addDirection(double x, double y, double z) {
        include(lowSpeed, highSpeed, x, y, z);
    }

    /** Adds directions whose components along an axis, 0, 1 or 2, are from {@code min} to {@code max}. */
    public void addDirectionRange(int axis, double min, double max) {
        lowSpeed[axis] = Math.min(lowSpeed[axis], min);
        highSpeed[axis] = Math.max(highSpeed[axis], max);
    }

    /** Aims all rays in one direction, of any length, without limit: to a directional light. */
    public void aimAlong(Vec3 direction) {
        addDirection(direction.x(), direction.y(), direction.z());
    }

    /** Aims all rays from their origins, which must be added before, at a point in render space. */
    public void aimAt(Vec3 point) {
        aimAt(point, point);
    }

    /** Aims all rays from their origins, which must be added before, at a box in render space. */
    public void aimAt(Vec3 min, Vec3 max) {
        double[] from = {min.x(), min.y(), min.z()};
        double[] to = {max.x(), max.y(), max.z()};
        for (int a = 0; a < 3; a++) {
            lowSpeed[a] = from[a] - low[a];
            highSpeed[a] = to[a] - high[a];
        }
        end = MAX_TIME;
    }

    /** Aims all rays in the directions of a box, of any length, without limit. */
    public void aimAlong(Vec3 low, Vec3 high) {
        addDirection(low.x(), low.y(), low.z());
        addDirection(high.x(), high.y(), high.z());
    }

    private static void include(double[] low, double[] high, double x, double y, double z) {
        low[0] = Math.min(low[0], x);
        low[1] = Math.min(low[1], y);
        low[2] = Math.min(low[2], z);
        high[0] = Math.max(high[0], x);
        high[1] = Math.max(high[1], y);
        high[2] = Math.max(high[2], z);
    }

    /**
     * Returns the time at which the beam first touches the padded box {@code boxes[at … at + 5]}.
     *
     * @return a time, or {@code +∞} for never
     */
    double entryTime(float[] boxes, int at) {
        double in = 0;
        double out = end;
        for (int a = 0; a < 3; a++) {
            // low + t·lowSpeed ≤ the box's maximum, and high + t·highSpeed ≥ its minimum
            double above = boxes[at + 3 + a] - low[a];
            double below = high[a] - boxes[at + a];
            double minSpeed = lowSpeed[a];
            double negatedMaxSpeed = -highSpeed[a];
            if (minSpeed > 0) {
                out = Math.min(out, above / minSpeed);
            } else if (minSpeed < 0) {
                in = Math.max(in, above / minSpeed);
            } else if (above < 0) {
                return Double.POSITIVE_INFINITY;
            }
            if (negatedMaxSpeed > 0) {
                out = Math.min(out, below / negatedMaxSpeed);
            } else if (negatedMaxSpeed < 0) {
                in = Math.max(in, below / negatedMaxSpeed);
            } else if (below < 0) {
                return Double.POSITIVE_INFINITY;
            }
        }
        return in <= out ? in : Double.POSITIVE_INFINITY;
    }
}
