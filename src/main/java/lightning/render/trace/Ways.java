package lightning.render.trace;

import lightning.base.math.Vec3;
import lightning.render.trace.tree.WayEnd;

/**
 * Where ways to a light lead: to a point, at distance 1, or in one direction without an end.
 *
 * @param source the point, or the direction of any length; render space
 * @param end    the end of ways to a point; {@link WayEnd#OPEN} for a direction
 * @param ends   whether it is a point
 */
public record Ways(Vec3 source, WayEnd end, boolean ends) {
    /** Ways to a point. */
    public static Ways to(WayEnd end) {
        return new Ways(end.point(), end, true);
    }

    /** Ways in a direction. */
    public static Ways along(Vec3 direction) {
        return new Ways(direction, WayEnd.OPEN, false);
    }

    /** Shapes at this distance or beyond do not block. */
    public double limit() {
        return ends ? 1 : Double.POSITIVE_INFINITY;
    }
}
