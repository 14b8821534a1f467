package lightning.render.trace.solid;

/** First hit on a convex solid, from the interval of the ray inside it. */
final class IntervalHit {
    private IntervalHit() {}

    /** Intersects the interval inside a side with the one with 0 ≤ y ≤ 1. NaN in the interval is a miss. */
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
     * Returns the hit on a side without caps, from outside or inside, with 0 ≤ y ≤ 1. The infinite side is convex: the ray is
     * inside during the interval and crosses the side at its ends. NaN in the interval is a miss.
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
     * Returns the hit of a ray that is inside a solid from {@code in} to {@code out}.
     *
     * <p>If an end of the ray is on the surface, rounding puts it on either side, and {@code in} or {@code out} decides nothing
     * there. The midpoint of the interval decides: it lies on the ray if the ray passes through the solid, otherwise beyond its
     * end.
     *
     * @param margin twice the distance from the end within which the midpoint decides nothing either, as where a ray only cuts
     *     off the tip of an edge or apex that contains the end
     */
    static double hitDistance(double in, double out, SurfaceContact touch, double margin) {
        return switch (touch) {
            case NONE -> nearest(in, out);
            case START -> in <= out && in + out > margin && out < SolidGeometry.MISS ? out : SolidGeometry.MISS;
            case END -> in <= out && in > 0 && in + out < 2 - margin ? in : SolidGeometry.MISS;
        };
    }

    /** Returns the first positive end of an interval; a miss if the interval is empty, behind the origin, or NaN. */
    private static double nearest(double in, double out) {
        boolean hit = in <= out && out > 0;
        double t = in > 0 ? in : out;
        return hit && t < SolidGeometry.MISS ? t : SolidGeometry.MISS;
    }
}
