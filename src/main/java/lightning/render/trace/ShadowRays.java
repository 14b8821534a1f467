package lightning.render.trace;

import lightning.base.math.Vec3;
import lightning.render.trace.tree.ShadowRayTarget;

/**
 * Shadow rays to one light: to a point, at distance 1, or in one direction without end.
 *
 * @param source point, or direction of any length; render space
 * @param target target of rays to a point; {@link ShadowRayTarget#OFF_SURFACE} for a direction
 * @param isPoint true for a point
 */
public record ShadowRays(Vec3 source, ShadowRayTarget target, boolean isPoint) {
    /** Returns shadow rays to a point. */
    public static ShadowRays toPoint(ShadowRayTarget end) {
        return new ShadowRays(end.point(), end, true);
    }

    /** Returns shadow rays in one direction. */
    public static ShadowRays inDirection(Vec3 direction) {
        return new ShadowRays(direction, ShadowRayTarget.OFF_SURFACE, false);
    }

    /** Returns the distance from which shapes do not block. */
    public double limit() {
        return isPoint ? 1 : Double.POSITIVE_INFINITY;
    }
}
