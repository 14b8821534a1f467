package lightning.format.exchange.assembly;

import java.util.function.DoubleUnaryOperator;
import lightning.base.math.Vec3;
import lightning.scene.value.Placement;
import lightning.scene.value.SceneLimits;

/** Angles of rotations of consecutive frames, so that an object does not turn back between two of them. */
public final class NearestAngles {
    private static final double FULL_TURN = 360;

    private NearestAngles() {}

    /** Returns a placement with the same transform whose angles are nearest to those of the frame before. */
    public static Placement continued(Placement before, Placement placement) {
        Vec3 best = of(placement.rotation(), before.rotation(), NineDigits::rounded);
        return best.maxAbs() <= SceneLimits.MAX_ROTATION ? placement.withRotation(best) : placement;
    }

    /**
     * Returns the angles of the same rotation that are nearest to the previous ones, degrees.
     *
     * @param rounding rounds each angle
     */
    public static Vec3 of(Vec3 angles, Vec3 previous, DoubleUnaryOperator rounding) {
        Vec3 one = unwrapped(angles, previous, rounding);
        Vec3 other = unwrapped(new Vec3(angles.x() + 180, 180 - angles.y(), angles.z() + 180), previous, rounding);
        return one.minus(previous).length() <= other.minus(previous).length() ? one : other;
    }

    private static Vec3 unwrapped(Vec3 angles, Vec3 previous, DoubleUnaryOperator rounding) {
        return new Vec3(unwrapped(angles.x(), previous.x(), rounding), unwrapped(angles.y(), previous.y(), rounding),
                unwrapped(angles.z(), previous.z(), rounding));
    }

    private static double unwrapped(double angle, double previous, DoubleUnaryOperator rounding) {
        return rounding.applyAsDouble(angle + FULL_TURN * Math.rint((previous - angle) / FULL_TURN));
    }
}
