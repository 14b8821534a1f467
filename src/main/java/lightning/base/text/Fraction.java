package lightning.base.text;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;

/**
 * A rational number, exact: what is typed into a field is reckoned with these, so that the only rounding is the last one.
 *
 * @param over  the numerator
 * @param under the denominator, above 0
 */
record Fraction(BigInteger over, BigInteger under) {
    static final Fraction ZERO = new Fraction(BigInteger.ZERO, BigInteger.ONE);
    static final Fraction HUNDRED = new Fraction(BigInteger.valueOf(100), BigInteger.ONE);
    /**
     * Two values that differ, one a double or the middle between two, the other one of these, are at least 1 / (under · 2^1075) apart; a
     * double is below 10^309, and 2^1075 below 10^324. So many digits beside those of {@code under} tell them apart.
     */
    private static final int DIGITS = 640;

    /** A finite value. */
    static Fraction of(BigDecimal v) {
        return v.scale() <= 0 ? new Fraction(v.toBigIntegerExact(), BigInteger.ONE)
                : new Fraction(v.unscaledValue(), BigInteger.TEN.pow(v.scale()));
    }

    Fraction plus(Fraction b) {
        return shortest(over.multiply(b.under).add(b.over.multiply(under)), under.multiply(b.under));
    }

    Fraction minus(Fraction b) {
        return plus(new Fraction(b.over.negate(), b.under));
    }

    Fraction times(Fraction b) {
        return shortest(over.multiply(b.over), under.multiply(b.under));
    }

    /** @throws ArithmeticException if {@code b} is 0 */
    Fraction by(Fraction b) {
        BigInteger below = under.multiply(b.over);
        BigInteger above = over.multiply(b.under);
        return below.signum() < 0 ? shortest(above.negate(), below.negate()) : shortest(above, below);
    }

    boolean isZero() {
        return over.signum() == 0;
    }

    /** The nearest double, ties to even; infinite where it is beyond 1.8e308. */
    double toDouble() {
        int digits = DIGITS + under.bitLength();
        return new BigDecimal(over).divide(new BigDecimal(under), new MathContext(digits)).doubleValue();
    }

    private static Fraction shortest(BigInteger over, BigInteger under) {
        BigInteger common = over.gcd(under);
        return new Fraction(over.divide(common), under.divide(common));
    }
}
