package lightning.scene.shot;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Vec3;
import lightning.base.math.VectorRotation;
import lightning.scene.attribute.NumericKind;

/** Interpolation between the numbers of two keyframes. */
final class KeyframeInterpolator {
    private KeyframeInterpolator() {}

    /**
     * Interpolates linearly. Each number stays between both values; a direction rotates on the shorter arc, and its length is interpolated.
     *
     * @param t 0 … 1
     */
    static List<Double> linear(NumericKind.Form form, List<Double> from, List<Double> to, double t) {
        if (form == NumericKind.Form.DIRECTION) {
            Vec3 turned = direction(vector(from), vector(to), t);
            return List.of(turned.x(), turned.y(), turned.z());
        }
        List<Double> result = new ArrayList<>(from.size());
        for (int i = 0; i < from.size(); i++) {
            result.add(linear(from.get(i), to.get(i), t));
        }
        return result;
    }

    private static double linear(double from, double to, double t) {
        return clampBetween(from, to, from * (1 - t) + to * t);
    }

    private static Vec3 direction(Vec3 from, Vec3 to, double t) {
        double length = from.length() * (1 - t) + to.length() * t;
        return from.equals(to) ? from : VectorRotation.slerp(from, to, t).times(length);
    }

    private static Vec3 vector(List<Double> numbers) {
        return new Vec3(numbers.get(0), numbers.get(1), numbers.get(2));
    }

    /**
     * Evaluates Hermite's cubic with given end slopes: 3t² − 2t³ of the difference, plus t(1 − t)² of the first slope, minus t²(1 − t) of
     * the second. It is monotone if each slope is 0 … 3 times that of the straight line (F. N. Fritsch, R. E. Carlson: Monotone Piecewise
     * Cubic Interpolation, SIAM J. Numer. Anal. 17, 1980).
     *
     * @param startSlope slope at {@code from}, per frame
     * @param endSlope   slope at {@code to}, per frame
     * @param frames     number of frames between, above 0
     * @param t          relative time, 0 … 1
     */
    static double cubic(double from, double to, double startSlope, double endSlope, double frames, double t) {
        double meanSlope = (to - from) / frames;
        if (meanSlope == 0) {
            return from;
        }
        double share = t * t * (3 - 2 * t) + startSlope / meanSlope * t * (1 - t) * (1 - t) - endSlope / meanSlope * t * t * (1 - t);
        return clampBetween(from, to, from + (to - from) * share);
    }

    /**
     * Computes the slope at a keyframe between two others for a monotone curve: the harmonic mean of both straight slopes, weighted by the
     * frames, or 0 if their signs differ (F. N. Fritsch, J. Butland: A Method for Constructing Local Monotone Piecewise Cubic Interpolants,
     * SIAM J. Sci. Stat. Comput. 5, 1984).
     *
     * @param framesBefore frames from {@code before} to {@code current}, above 0
     * @param framesAfter  frames from {@code current} to {@code after}, above 0
     */
    static double slope(double before, double current, double after, double framesBefore, double framesAfter) {
        double slopeBefore = (current - before) / framesBefore;
        double slopeAfter = (after - current) / framesAfter;
        if (Math.signum(slopeBefore) * Math.signum(slopeAfter) <= 0) {
            return 0;
        }
        double w1 = 2 * framesAfter + framesBefore;
        double w2 = framesAfter + 2 * framesBefore;
        return (w1 + w2) / (w1 / slopeBefore + w2 / slopeAfter);
    }

    /** Clamps a number to the range of both keyframes, against rounding. */
    private static double clampBetween(double a, double b, double v) {
        return Math.clamp(v, Math.min(a, b), Math.max(a, b));
    }
}
