package lightning.render.trace;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import lightning.base.math.Vec3;
import lightning.scene.value.Placement;

/** Transforms of placed shapes in arbitrary precision, computed only from the numbers of the scene. */
final class ExactPlacement {
    private static final MathContext DIGITS = new MathContext(100);
    private static final BigDecimal PI = pi();

    private final List<Placement> placements;

    /** @param placements placements from the outermost group to the shape */
    ExactPlacement(List<Placement> placements) {
        this.placements = placements;
    }

    /** Returns the scene point with local coordinates {@code local}. */
    BigDecimal[] toScene(BigDecimal[] local) {
        BigDecimal[] p = local;
        for (Placement placement : placements.reversed()) {
            BigDecimal[] scaled = {p[0].multiply(exact(placement.scale().x())), p[1].multiply(exact(placement.scale().y())),
                p[2].multiply(exact(placement.scale().z()))};
            BigDecimal[] turned =
                    rotate(rotate(rotate(scaled, 0, placement.rotation().x()), 1, placement.rotation().y()), 2, placement.rotation().z());
            BigDecimal[] at = ExactSolids.exact(placement.position().x(), placement.position().y(), placement.position().z());
            p = new BigDecimal[] {round(turned[0].add(at[0])), round(turned[1].add(at[1])), round(turned[2].add(at[2]))};
        }
        return p;
    }

    /** Returns the local coordinates of a scene point. */
    BigDecimal[] toLocal(BigDecimal[] scene) {
        BigDecimal[] p = scene;
        for (Placement placement : placements) {
            Vec3 at = placement.position();
            BigDecimal[] moved = {p[0].subtract(exact(at.x())), p[1].subtract(exact(at.y())), p[2].subtract(exact(at.z()))};
            BigDecimal[] turned =
                    rotate(rotate(rotate(moved, 2, -placement.rotation().z()), 1, -placement.rotation().y()), 0, -placement.rotation().x());
            p = new BigDecimal[] {turned[0].divide(exact(placement.scale().x()), DIGITS),
                turned[1].divide(exact(placement.scale().y()), DIGITS),
                turned[2].divide(exact(placement.scale().z()), DIGITS)};
        }
        return p;
    }

    /** Rotates counterclockwise around an axis, seen from its positive end. */
    private static BigDecimal[] rotate(BigDecimal[] p, int axis, double degrees) {
        BigDecimal radians = exact(degrees).remainder(BigDecimal.valueOf(360)).multiply(PI).divide(BigDecimal.valueOf(180), DIGITS);
        BigDecimal sine = series(radians, radians, 2);
        BigDecimal cosine = series(BigDecimal.ONE, radians, 1);
        int a = (axis + 1) % 3;
        int b = (axis + 2) % 3;
        BigDecimal[] q = p.clone();
        q[a] = round(cosine.multiply(p[a]).subtract(sine.multiply(p[b])));
        q[b] = round(sine.multiply(p[a]).add(cosine.multiply(p[b])));
        return q;
    }

    /** Computes first − first·x²/(k(k + 1)) + …, the series of sine and cosine. */
    private static BigDecimal series(BigDecimal first, BigDecimal x, int k) {
        BigDecimal square = round(x.multiply(x));
        BigDecimal term = first;
        BigDecimal sum = first;
        for (int n = k; term.signum() != 0 && term.abs().compareTo(new BigDecimal("1e-95")) > 0; n += 2) {
            term = term.multiply(square).divide(BigDecimal.valueOf((long) n * (n + 1)), DIGITS).negate();
            sum = round(sum.add(term));
        }
        return sum;
    }

    /** Computes π by Machin's formula 16·arctan(1/5) − 4·arctan(1/239). */
    private static BigDecimal pi() {
        return arctan(5).multiply(BigDecimal.valueOf(16)).subtract(arctan(239).multiply(BigDecimal.valueOf(4)));
    }

    private static BigDecimal arctan(int inverse) {
        BigDecimal power = BigDecimal.ONE.divide(BigDecimal.valueOf(inverse), DIGITS);
        BigDecimal sum = power;
        for (int n = 3; n < 150; n += 2) {
            power = power.divide(BigDecimal.valueOf(-(long) inverse * inverse), DIGITS);
            sum = sum.add(power.divide(BigDecimal.valueOf(n), DIGITS));
        }
        return sum;
    }

    private static BigDecimal exact(double v) {
        return new BigDecimal(v);
    }

    private static BigDecimal round(BigDecimal v) {
        return v.round(DIGITS);
    }
}
