package lightning.base.text;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.math.MathContext;

/**
 * Exact rational number, so that an expression in a field is rounded only once.
 *
 * @param numerator   the numerator
 * @param denominator the denominator, above 0
 */
record Fraction(BigInteger numerator, BigInteger denominator) {
    static final Fraction ZERO = new Fraction(BigInteger.ZERO, BigInteger.ONE);
    static final Fraction HUNDRED = new Fraction(BigInteger.valueOf(100), BigInteger.ONE);
    /**
     * Digits that separate any two different values. If one is a double or the middle of two and the other is a fraction, they are at least
     * 1 / (denominator · 2^1075) apart; a double is below 10^309, and 2^1075 below 10^324. Added to the digits of {@code denominator}.
     */
    private static final int DIGITS = 640;

    /** Converts a finite value. */
    static Fraction of(BigDecimal v) {
        return v.scale() <= 0 ? new Fraction(v.toBigIntegerExact(), BigInteger.ONE)
                : new Fraction(v.unscaledValue(), BigInteger.TEN.pow(v.scale()));
    }

    Fraction plus(Fraction b) {
        return reduce(numerator.multiply(b.denominator).add(b.numerator.multiply(denominator)), denominator.multiply(b.denominator));
    }

    Fraction minus(Fraction b) {
        return plus(new Fraction(b.numerator.negate(), b.denominator));
    }

    Fraction times(Fraction b) {
        return reduce(numerator.multiply(b.numerator), denominator.multiply(b.denominator));
    }

    /** @throws ArithmeticException if {@code b} is 0 */
    Fraction divide(Fraction b) {
        BigInteger below = denominator.multiply(b.numerator);
        BigInteger above = numerator.multiply(b.denominator);
        return below.signum() < 0 ? reduce(above.negate(), below.negate()) : reduce(above, below);
    }

    boolean isZero() {
        return numerator.signum() == 0;
    }

    /** Returns the nearest double, ties to even; infinite beyond 1.8e308. */
    double toDouble() {
        int digits = DIGITS + denominator.bitLength();
        return new BigDecimal(numerator).divide(new BigDecimal(denominator), new MathContext(digits)).doubleValue();
    }

    private static Fraction reduce(BigInteger numerator, BigInteger denominator) {
        BigInteger common = numerator.gcd(denominator);
        return new Fraction(numerator.divide(common), denominator.divide(common));
    }
}
