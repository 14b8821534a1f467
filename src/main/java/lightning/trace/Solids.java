package lightning.trace;

/**
 * Distances from a ray to the four canonical solids, in the solid's own space: the readable form
 * that the packets must repeat operation by operation.
 *
 * <p>Every method takes origin and direction (any length) and returns the smallest distance
 * {@code t > 0} at which the ray meets the surface, or {@code +∞}. The curved solids are convex, so a
 * ray is inside along one interval: the intersection of its intervals with the side and with the
 * slab between the caps. Rim and cap then cannot disagree.
 */
final class Solids {
    static final double MISS = Double.POSITIVE_INFINITY;
    /** Below this ratio of (sideways / along)² a ray through a cylinder does not move sideways. */
    static final double PARALLEL = 0x1p-200;

    private Solids() {}

    /**
     * The unit sphere. The discriminant b² − ac is |d|² − |o × d|² by Lagrange's identity, which
     * loses no digits to cancellation far from the sphere, and each root is the quotient that loses
     * none near it (after Haines et al., Ray Tracing Gems, ch. 7). Only the nearest root ahead is
     * divided out: the second one for a ray that leaves from inside, else the first. That |c·a| ≤ q² holds;
     * where it fails by far, c and q are mere rounding of a ray that touches the surface it leaves: a miss.
     */
    static double sphere(double ox, double oy, double oz, double dx, double dy, double dz) {
        double a = dx * dx + dy * dy + dz * dz;
        double b = -(ox * dx + oy * dy + oz * dz);
        double c = ox * ox + oy * oy + oz * oz - 1;
        double u = oy * dz - oz * dy;
        double v = oz * dx - ox * dz;
        double w = ox * dy - oy * dx;
        double root = Math.sqrt(a - (u * u + v * v + w * w));
        double q = b >= 0 ? b + root : b - root;
        boolean leaves = c <= 0 && b >= 0;
        double t = (leaves ? q : c) / (leaves ? a : q);
        return t > 0 && t < MISS && Math.abs(c * a) <= 2 * q * q ? t : MISS;
    }

    /** The unit sphere for a way that ends on it, or begins there. */
    static double sphere(double ox, double oy, double oz, double dx, double dy, double dz, Touch touch, double margin) {
        double a = dx * dx + dy * dy + dz * dz;
        double b = -(ox * dx + oy * dy + oz * dz);
        double c = ox * ox + oy * oy + oz * oz - 1;
        double u = oy * dz - oz * dy;
        double v = oz * dx - ox * dz;
        double w = ox * dy - oy * dx;
        double root = Math.sqrt(a - (u * u + v * v + w * w));
        double q = b >= 0 ? b + root : b - root;
        double t0 = c / q;
        double t1 = q / a;
        return Math.abs(c * a) <= 2 * q * q ? met(t0 < t1 ? t0 : t1, t0 < t1 ? t1 : t0, touch, margin) : MISS;
    }

    /** The cylinder of radius 1 about the y axis, from y = 0 to y = 1, with its caps. */
    static double cylinder(double ox, double oy, double oz, double dx, double dy, double dz) {
        return cylinder(ox, oy, oz, dx, dy, dz, Touch.NEITHER, 0);
    }

    /** The cylinder for a way of which an end may lie on it. */
    static double cylinder(double ox, double oy, double oz, double dx, double dy, double dz, Touch touch, double margin) {
        double a = dx * dx + dz * dz;
        double b = -(ox * dx + oz * dz);
        double c = ox * ox + oz * oz - 1;
        double w = ox * dz - oz * dx;
        double root = Math.sqrt(a - w * w);
        double q = b >= 0 ? b + root : b - root;
        double t0 = c / q;
        double t1 = q / a;
        boolean parallel = a <= dy * dy * PARALLEL;
        boolean touches = Math.abs(c * a) > 2 * q * q;
        double far = c <= 0 ? MISS : -MISS;
        double sideIn = parallel ? -far : touches ? MISS : t0 < t1 ? t0 : t1;
        double sideOut = parallel ? far : t0 < t1 ? t1 : t0;
        return withinSlab(sideIn, sideOut, oy, dy, touch, margin);
    }

    /**
     * The cone with its base of radius 1 at y = 0 and its apex at y = 1. With h = 1 − y its side is
     * x² + z² = h².
     *
     * <p>The origin is first moved along the ray to its point nearest to the apex. Otherwise the terms of a ray
     * from far away that runs along a generator cancel, and the error grows with the square of the distance
     * (Haines et al., Ray Tracing Gems, ch. 7, do so for the sphere). The discriminant is Lagrange's identity for
     * that form. A ray steeper than the side always crosses the double cone, and for a point at a right angle to it this
     * discriminant is a sum of squares, w²·(dh²/side − 1) among them; b² − ac rounds to either side of 0 at the apex.
     */
    static double cone(double ox, double oy, double oz, double dx, double dy, double dz) {
        return cone(ox, oy, oz, dx, dy, dz, Touch.NEITHER, 0);
    }

    /** The cone for a way of which an end may lie on it. */
    static double cone(double ox, double oy, double oz, double dx, double dy, double dz, Touch touch, double margin) {
        double top = 1 - oy;
        double dh = -dy;
        double side = dx * dx + dz * dz;
        double up = dh * dh;
        double shift = -(ox * dx + oz * dz + top * dh) / (side + up);
        double x = ox + shift * dx;
        double h = top + shift * dh;
        double z = oz + shift * dz;
        double a = side - up;
        double b = h * dh - (x * dx + z * dz);
        double c = x * x + z * z - h * h;
        double u = x * dh - h * dx;
        double v = z * dh - h * dz;
        double w = x * dz - z * dx;
        double root = Math.sqrt(u * u + v * v - w * w);
        double q = b >= 0 ? b + root : b - root;
        double t1 = shift + q / a;
        double t0 = q == 0 ? t1 : shift + c / q;
        double low = t0 < t1 ? t0 : t1;
        double high = t0 < t1 ? t1 : t0;
        // Steeper than the side (a < 0) the ray enters the lower half of the double cone once and
        // stays; along a generator (a = 0) only one root is left.
        boolean steep = a < 0;
        boolean generator = a == 0;
        boolean forwards = steep ? dh > 0 : b >= 0;
        double bound = steep ? (dh > 0 ? high : low) : t0;
        double sideIn = steep || generator ? (forwards ? bound : -MISS) : low;
        double sideOut = steep || generator ? (forwards ? MISS : bound) : high;
        // Where there is no real root, one end of the interval at least is NaN: a miss by itself.
        boolean none = Math.abs(c * a) > 2 * q * q;
        return withinSlab(none ? MISS : sideIn, none ? -MISS : sideOut, oy, dy, touch, margin);
    }

    /** The unit square about the origin in the plane y = 0. */
    static double plane(double ox, double oy, double oz, double dx, double dy, double dz) {
        double t = -oy / dy;
        double x = ox + t * dx;
        double z = oz + t * dz;
        boolean hit = t > 0 && t < MISS && Math.abs(x) <= 0.5 && Math.abs(z) <= 0.5;
        return hit ? t : MISS;
    }

    /** Cuts an interval with the one in which 0 ≤ y ≤ 1. NaN in the interval is a miss. */
    private static double withinSlab(double sideIn, double sideOut, double oy, double dy, Touch touch, double margin) {
        double inverse = 1 / dy;
        double t0 = -oy * inverse;
        double t1 = (1 - oy) * inverse;
        boolean level = Math.abs(inverse) == MISS;
        double far = oy >= 0 && oy <= 1 ? MISS : -MISS;
        double slabIn = level ? -far : t0 < t1 ? t0 : t1;
        double slabOut = level ? far : t0 < t1 ? t1 : t0;
        double in = sideIn < slabIn ? slabIn : sideIn;
        double out = slabOut < sideOut ? slabOut : sideOut;
        return met(in, out, touch, margin);
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
    private static double met(double in, double out, Touch touch, double margin) {
        return switch (touch) {
            case NEITHER -> nearest(in, out);
            case START -> in <= out && in + out > margin && out < MISS ? out : MISS;
            case END -> in <= out && in > 0 && in + out < 2 - margin ? in : MISS;
        };
    }

    /** The first positive end of an interval; a miss if it is empty, behind or NaN. */
    private static double nearest(double in, double out) {
        boolean hit = in <= out && out > 0;
        double t = in > 0 ? in : out;
        return hit && t < MISS ? t : MISS;
    }
}
