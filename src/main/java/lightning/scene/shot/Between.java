package lightning.scene.shot;

import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Rotation;
import lightning.base.math.Vec3;
import lightning.scene.Quantity;

/** What lies between the numbers of two keys. */
final class Between {
    private Between() {}

    /**
     * A part of the even way from one value to another. Numbers stay between those of the two, each for itself; a direction turns on
     * the shorter arc, and its length goes evenly.
     *
     * @param share 0 … 1
     */
    static List<Double> linear(Quantity.Form form, List<Double> from, List<Double> to, double share) {
        if (form == Quantity.Form.DIRECTION) {
            Vec3 turned = direction(vector(from), vector(to), share);
            return List.of(turned.x(), turned.y(), turned.z());
        }
        List<Double> all = new ArrayList<>(from.size());
        for (int i = 0; i < from.size(); i++) {
            all.add(linear(from.get(i), to.get(i), share));
        }
        return all;
    }

    private static double linear(double from, double to, double share) {
        return within(from, to, from * (1 - share) + to * share);
    }

    private static Vec3 direction(Vec3 from, Vec3 to, double share) {
        double length = from.length() * (1 - share) + to.length() * share;
        return from.equals(to) ? from : Rotation.between(from, to, share).times(length);
    }

    private static Vec3 vector(List<Double> numbers) {
        return new Vec3(numbers.get(0), numbers.get(1), numbers.get(2));
    }

    /**
     * A place on Hermite's cubic with given slopes at its ends: 3t² − 2t³ of the way, and t(1 − t)² of the first slope less
     * t²(1 − t) of the second. It is monotone where each slope is 0 … 3 times that of the straight way (F. N. Fritsch, R. E. Carlson:
     * Monotone Piecewise Cubic Interpolation, SIAM J. Numer. Anal. 17, 1980).
     *
     * @param slope  at {@code from}, per frame; at the end {@code next}
     * @param frames from one to the other, above 0
     * @param t      the share of the way in time, 0 … 1
     */
    static double smooth(double from, double to, double slope, double next, double frames, double t) {
        double straight = (to - from) / frames;
        if (straight == 0) {
            return from;
        }
        double share = t * t * (3 - 2 * t) + slope / straight * t * (1 - t) * (1 - t) - next / straight * t * t * (1 - t);
        return within(from, to, from + (to - from) * share);
    }

    /**
     * The slope at a key between two others, by which the curve is monotone from key to key: the harmonic mean of the two straight
     * slopes, weighted by the frames, or 0 where one goes up and the other does not (F. N. Fritsch, J. Butland: A Method for
     * Constructing Local Monotone Piecewise Cubic Interpolants, SIAM J. Sci. Stat. Comput. 5, 1984).
     *
     * @param framesBefore from {@code before} to {@code here}, above 0; {@code framesAfter} likewise
     */
    static double slope(double before, double here, double after, double framesBefore, double framesAfter) {
        double first = (here - before) / framesBefore;
        double second = (after - here) / framesAfter;
        if (Math.signum(first) * Math.signum(second) <= 0) {
            return 0;
        }
        double w1 = 2 * framesAfter + framesBefore;
        double w2 = framesAfter + 2 * framesBefore;
        return (w1 + w2) / (w1 / first + w2 / second);
    }

    /** Rounding carries no number beyond what the two keys say. */
    private static double within(double a, double b, double v) {
        return Math.clamp(v, Math.min(a, b), Math.max(a, b));
    }
}
