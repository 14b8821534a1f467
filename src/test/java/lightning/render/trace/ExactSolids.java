package lightning.render.trace;

import java.math.BigDecimal;
import java.math.MathContext;
import lightning.render.trace.solid.SolidGeometry;
import lightning.scene.node.Solid;

/**
 * Reference intersection of the canonical solids with 130 digits, for tests of {@link SolidGeometry}.
 *
 * <p>A solid may be grown or shrunk by a margin. A distance is correct if it is correct for any solid between the shrunk and
 * the grown one: then it is the exact result for a ray, or a shape, that differs from the given one by at most the margin.
 */
final class ExactSolids {
    private static final MathContext DIGITS = new MathContext(130);
    private static final BigDecimal TWO = BigDecimal.TWO;
    /** End of an infinite interval: greater than any distance of the tests. */
    private static final BigDecimal INFINITE = new BigDecimal("1e400");

    private ExactSolids() {}

    /** Interval of distances along a ray. */
    record Interval(BigDecimal in, BigDecimal out) {
        boolean isEmpty() {
            return in.compareTo(out) > 0;
        }

        boolean contains(BigDecimal t) {
            return t.compareTo(in) >= 0 && t.compareTo(out) <= 0;
        }

        Interval intersect(Interval other) {
            return new Interval(in.max(other.in), out.min(other.out));
        }
    }

    private static final Interval EMPTY = new Interval(INFINITE, INFINITE.negate());
    private static final Interval ALL_REALS = new Interval(INFINITE.negate(), INFINITE);

    static BigDecimal[] exact(double... v) {
        BigDecimal[] e = new BigDecimal[v.length];
        for (int i = 0; i < v.length; i++) {
            e[i] = new BigDecimal(v[i]);
        }
        return e;
    }

    /**
     * Returns the error of a distance as text, or null if it is correct.
     *
     * @param solid any solid except a plane
     * @param t computed distance, {@code +∞} for a miss
     * @param margin distance by which the solid may be grown or shrunk, local units
     */
    static String error(Solid.Canonical solid, BigDecimal[] o, BigDecimal[] d, double t, double margin) {
        if (CanonicalSolids.isOpen(solid)) {
            return openSolidError(solid, o, d, t, new BigDecimal(margin));
        }
        BigDecimal zero = BigDecimal.ZERO;
        Interval grown = insideInterval(solid, o, d, new BigDecimal(margin));
        Interval shrunk = insideInterval(solid, o, d, new BigDecimal(-margin));
        if (t == SolidGeometry.MISS) {
            return shrunk.isEmpty() || shrunk.out.compareTo(zero) <= 0 ? null : "missed, although inside at " + text(shrunk);
        }
        if (!(t > 0)) {
            return "distance " + t;
        }
        BigDecimal at = new BigDecimal(t);
        if (grown.isEmpty() || at.compareTo(grown.in) < 0 || at.compareTo(grown.out) > 0) {
            return "hit at " + t + " outside: the grown solid is at " + text(grown);
        }
        if (shrunk.isEmpty() || shrunk.out.compareTo(zero) <= 0) {
            return null;
        }
        boolean first = shrunk.in.compareTo(zero) > 0 && at.compareTo(shrunk.in) <= 0;
        boolean last = at.compareTo(shrunk.out) >= 0 && (shrunk.in.compareTo(zero) <= 0 || grown.in.compareTo(zero) <= 0);
        return first || last ? null : "hit at " + t + " is not the first surface: inside at " + text(shrunk);
    }

    /**
     * Returns the error for a side without caps, which is crossed between the ends of the shrunk interval and those of the
     * grown one.
     */
    private static String openSolidError(Solid.Canonical solid, BigDecimal[] o, BigDecimal[] d, double t, BigDecimal margin) {
        Interval grown = sideInterval(solid, o, d, margin);
        Interval shrunk = sideInterval(solid, o, d, margin.negate());
        Interval rims = rimInterval(o, d, margin.negate());
        boolean first = !shrunk.isEmpty() && grown.in.signum() > 0 && rims.contains(grown.in) && rims.contains(shrunk.in);
        boolean last = !shrunk.isEmpty() && shrunk.out.signum() > 0 && rims.contains(shrunk.out) && rims.contains(grown.out);
        if (t == SolidGeometry.MISS) {
            return first || last ? "missed, although inside the side at " + text(shrunk) : null;
        }
        BigDecimal at = new BigDecimal(t);
        if (!(t > 0) || grown.isEmpty() || !grown.contains(at) || !rimInterval(o, d, margin).contains(at)) {
            return "hit at " + t + " outside: the grown side is at " + text(grown);
        }
        boolean within = !shrunk.isEmpty() && at.compareTo(shrunk.in) > 0 && at.compareTo(shrunk.out) < 0;
        boolean late = first && at.compareTo(shrunk.in) > 0;
        return within || late ? "hit at " + t + " is not the first crossing: inside the side at " + text(shrunk) : null;
    }

    private static String text(Interval i) {
        return i.isEmpty() ? "nowhere" : i.in.doubleValue() + " … " + i.out.doubleValue();
    }

    /** Returns the interval of a ray inside the solid grown by a margin. */
    static Interval insideInterval(Solid.Canonical solid, BigDecimal[] o, BigDecimal[] d, BigDecimal grow) {
        if (solid instanceof Solid.Sphere) {
            BigDecimal radius = BigDecimal.ONE.add(grow);
            return rootInterval(dot(d, d), dot(o, d).negate(), dot(o, o).subtract(square(radius)));
        }
        return sideInterval(solid, o, d, grow).intersect(rimInterval(o, d, grow));
    }

    /**
     * Returns the interval of a ray inside the infinite side of a round solid. The side is grown by a margin perpendicular to
     * it or, up to a cone, along x and z.
     */
    static Interval sideInterval(Solid.Canonical solid, BigDecimal[] o, BigDecimal[] d, BigDecimal grow) {
        BigDecimal lean = BigDecimal.ONE.subtract(new BigDecimal(CanonicalSolids.topRadius(solid)));
        BigDecimal base = BigDecimal.ONE.add(grow.multiply(lean.abs().max(BigDecimal.ONE)));
        return solid instanceof Solid.Cylinder
                ? rootInterval(square(d[0]).add(square(d[2])), o[0].multiply(d[0]).add(o[2].multiply(d[2])).negate(),
                        square(o[0]).add(square(o[2])).subtract(square(base)))
                : coneInterval(o, d, base.subtract(lean.multiply(o[1])), lean.multiply(d[1]).negate());
    }

    /**
     * Returns the interval of a ray inside the convex set of {@link lightning.render.trace.solid.SolidGeometry}: the solid or,
     * without caps, its infinite side.
     */
    static Interval convexInterval(Solid.Canonical solid, BigDecimal[] o, BigDecimal[] d, BigDecimal grow) {
        return CanonicalSolids.isOpen(solid) ? sideInterval(solid, o, d, grow) : insideInterval(solid, o, d, grow);
    }

    /** Returns whether a part of a ray is certainly between the rims. */
    static boolean isBetweenRims(BigDecimal[] o, BigDecimal[] d, BigDecimal from, BigDecimal to, double error) {
        Interval rims = rimInterval(o, d, new BigDecimal(-error));
        return rims.contains(from) && rims.contains(to);
    }

    /** Returns whether a part of a ray is certainly beyond the rims. */
    static boolean isBeyondRims(BigDecimal[] o, BigDecimal[] d, BigDecimal from, BigDecimal to, double error) {
        return rimInterval(o, d, new BigDecimal(error)).intersect(new Interval(from, to)).isEmpty();
    }

    /** Returns the interval of a ray between the rims of a round solid, moved outward by a margin. */
    static Interval rimInterval(BigDecimal[] o, BigDecimal[] d, BigDecimal grow) {
        return slabInterval(o[1], d[1], grow.negate(), BigDecimal.ONE.add(grow));
    }

    /** Solves a·t² − 2·b·t + c ≤ 0, for a ≥ 0. */
    private static Interval rootInterval(BigDecimal a, BigDecimal b, BigDecimal c) {
        if (a.signum() == 0) {
            return c.signum() <= 0 ? ALL_REALS : EMPTY;
        }
        BigDecimal disc = square(b).subtract(a.multiply(c));
        if (disc.signum() < 0) {
            return EMPTY;
        }
        BigDecimal root = disc.sqrt(DIGITS);
        return new Interval(b.subtract(root).divide(a, DIGITS), b.add(root).divide(a, DIGITS));
    }

    private static Interval slabInterval(BigDecimal o, BigDecimal d, BigDecimal low, BigDecimal high) {
        if (d.signum() == 0) {
            return o.compareTo(low) >= 0 && o.compareTo(high) <= 0 ? ALL_REALS : EMPTY;
        }
        BigDecimal t0 = low.subtract(o).divide(d, DIGITS);
        BigDecimal t1 = high.subtract(o).divide(d, DIGITS);
        return new Interval(t0.min(t1), t0.max(t1));
    }

    /** Solves √(x² + z²) ≤ h + t·dh: one interval, because that is convex. */
    private static Interval coneInterval(BigDecimal[] o, BigDecimal[] d, BigDecimal h, BigDecimal dh) {
        BigDecimal a = square(d[0]).add(square(d[2])).subtract(square(dh));
        BigDecimal b = h.multiply(dh).subtract(o[0].multiply(d[0])).subtract(o[2].multiply(d[2]));
        BigDecimal c = square(o[0]).add(square(o[2])).subtract(square(h));
        if (a.signum() == 0) {
            if (b.signum() == 0) {
                return c.signum() <= 0 && h.signum() >= 0 ? ALL_REALS : EMPTY;
            }
            if (b.signum() * dh.signum() < 0) {
                return EMPTY; // along a generator, inside the other half of the double cone, where the radius is below 0
            }
            BigDecimal t = c.divide(b.multiply(TWO), DIGITS);
            return b.signum() > 0 ? new Interval(t, INFINITE) : new Interval(INFINITE.negate(), t);
        }
        BigDecimal disc = square(b).subtract(a.multiply(c));
        if (disc.signum() < 0) {
            return EMPTY;
        }
        BigDecimal root = disc.sqrt(DIGITS);
        BigDecimal t0 = b.subtract(root).divide(a, DIGITS);
        BigDecimal t1 = b.add(root).divide(a, DIGITS);
        if (a.signum() < 0) {
            return dh.signum() > 0 ? new Interval(t0.max(t1), INFINITE) : new Interval(INFINITE.negate(), t0.min(t1));
        }
        BigDecimal middle = b.divide(a, DIGITS);
        return h.add(middle.multiply(dh)).signum() >= 0 ? new Interval(t0, t1) : EMPTY;
    }

    private static BigDecimal dot(BigDecimal[] v, BigDecimal[] w) {
        return v[0].multiply(w[0]).add(v[1].multiply(w[1])).add(v[2].multiply(w[2]));
    }

    private static BigDecimal square(BigDecimal v) {
        return v.multiply(v);
    }
}
