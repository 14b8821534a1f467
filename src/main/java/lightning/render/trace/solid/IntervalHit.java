package lightning.render.trace.solid;

/** What a ray meets first of a convex solid that it is in along one interval. */
final class IntervalHit {
    private IntervalHit() {}

    /** Cuts the interval within a side with the one in which 0 ≤ y ≤ 1. NaN in the interval is a miss. */
    static double hitWithCaps(double sideIn, double sideOut, double oy, double dy, SurfaceContact touch, double margin) {
        double inverse = 1 / dy;
        double t0 = -oy * inverse;
        double t1 = (1 - oy) * inverse;
        boolean level = Math.abs(inverse) == SolidGeometry.MISS;
        double far = oy >= 0 && oy <= 1 ? SolidGeometry.MISS : -SolidGeometry.MISS;
        double slabIn = level ? -far : t0 < t1 ? t0 : t1;
        double slabOut = level ? far : t0 < t1 ? t1 : t0;
        double in = sideIn < slabIn ? slabIn : sideIn;
        double out = slabOut < sideOut ? slabOut : sideOut;
        return hitDistance(in, out, touch, margin);
    }

    /**
     * What is met of a side alone, from without or from within, where 0 ≤ y ≤ 1. The side, without its end, is convex: a way is
     * within it along the interval, and crosses it at the ends. NaN in the interval is a miss.
     */
    static double hitWithoutCaps(double sideIn, double sideOut, double oy, double dy, SurfaceContact touch, double margin) {
        double inverse = 1 / dy;
        double t0 = -oy * inverse;
        double t1 = (1 - oy) * inverse;
        boolean level = Math.abs(inverse) == SolidGeometry.MISS;
        double far = oy >= 0 && oy <= 1 ? SolidGeometry.MISS : -SolidGeometry.MISS;
        double slabIn = level ? -far : t0 < t1 ? t0 : t1;
        double slabOut = level ? far : t0 < t1 ? t1 : t0;
        boolean first = sideIn >= slabIn && sideIn <= slabOut;
        boolean last = sideOut >= slabIn && sideOut <= slabOut;
        if (touch != SurfaceContact.NONE) {
            double t = hitDistance(sideIn, sideOut, touch, margin);
            return (touch == SurfaceContact.START ? last : first) ? t : SolidGeometry.MISS;
        }
        boolean enters = first && sideIn > 0;
        boolean leaves = last && sideOut > 0;
        double t = enters ? sideIn : sideOut;
        return sideIn <= sideOut && (enters || leaves) ? t : SolidGeometry.MISS;
    }

    /**
     * What a way meets of a solid that it is in from {@code in} to {@code out}.
     *
     * <p>An end on the surface is, by rounding, a little before it or behind it, and {@code in} or {@code out} tells nothing
     * there. The middle of the interval does: it lies on the way if the way goes through the solid, else beyond its end.
     *
     * @param margin twice the distance from the end up to which the middle tells nothing either, as where a way only
     *               cuts off the tip of an edge or of an apex on which the end lies
     */
    static double hitDistance(double in, double out, SurfaceContact touch, double margin) {
        return switch (touch) {
            case NONE -> nearest(in, out);
            case START -> in <= out && in + out > margin && out < SolidGeometry.MISS ? out : SolidGeometry.MISS;
            case END -> in <= out && in > 0 && in + out < 2 - margin ? in : SolidGeometry.MISS;
        };
    }

    /** The first positive end of an interval; a miss if it is empty, behind or NaN. */
    private static double nearest(double in, double out) {
        boolean hit = in <= out && out > 0;
        double t = in > 0 ? in : out;
        return hit && t < SolidGeometry.MISS ? t : SolidGeometry.MISS;
    }
}
