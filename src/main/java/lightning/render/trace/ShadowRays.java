package lightning.render.trace;

import lightning.base.math.Vec3;
import lightning.render.trace.tree.ShadowRayTarget;

/**
 * Where ways to a light lead: to a point, at distance 1, or in one direction without an end.
 *
 * @param source the point, or the direction of any length; render space
 * @param target    the end of ways to a point; {@link ShadowRayTarget#OFF_SURFACE} for a direction
 * @param isPoint   whether it is a point
 */
public record ShadowRays(Vec3 source, ShadowRayTarget target, boolean isPoint) {
    /** Ways to a point. */
    public static ShadowRays toPoint(ShadowRayTarget end) {
        return new ShadowRays(end.point(), end, true);
    }

    /** Ways in a direction. */
    public static ShadowRays inDirection(Vec3 direction) {
        return new ShadowRays(direction, ShadowRayTarget.OFF_SURFACE, false);
    }

    /** Shapes at this distance or beyond do not block. */
    public double limit() {
        return isPoint ? 1 : Double.POSITIVE_INFINITY;
    }
}
