package lightning.render.engine.lanes;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorMask;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;
import lightning.base.math.PowerFunction;

/** Lane version of {@link PowerFunction#pow}: the same operations in the same order, hence the same bits. */
public final class PowerLanes {
    private static final VectorSpecies<Double> D = DoubleVector.SPECIES_PREFERRED;
    private static final VectorSpecies<Long> L = LongVector.SPECIES_PREFERRED;

    private PowerLanes() {}

    /** Replaces {@code x[from … to)} by its power; overruns the end to a whole number of lanes. */
    public static void of(double[] x, int from, int to, double n) {
        for (int i = from; i < to; i += D.length()) {
            logarithm(x, i, n);
        }
        for (int i = from; i < to; i += D.length()) {
            exponential(x, i);
        }
    }

    /** Replaces {@code p[0 … count)} by 2^p, and −∞ by 0; overruns the end to a whole number of lanes. */
    static void exponentials(double[] p, int count) {
        for (int i = 0; i < count; i += D.length()) {
            exponential(p, i);
        }
    }

    /** Replaces x by n·log₂x, or −∞ if the power is 0. */
    private static void logarithm(double[] values, int i, double n) {
        DoubleVector x = DoubleVector.fromArray(D, values, i);
        VectorMask<Double> normal = x.compare(VectorOperators.GE, Double.MIN_NORMAL);
        LongVector bits = x.reinterpretAsLongs();
        LongVector mantissa = bits.and(PowerFunction.MANTISSA);
        VectorMask<Long> upper = mantissa.compare(VectorOperators.GT, PowerFunction.SQRT2_MANTISSA);
        // The biased exponent, inserted into the mantissa of 2^52, is a double without a conversion.
        DoubleVector biased = bits.lanewise(VectorOperators.LSHR, 52).or(0x4330000000000000L).reinterpretAsDoubles().sub(0x1p52);
        DoubleVector exponent = biased.sub(DoubleVector.broadcast(D, 1023).blend(1022, upper.cast(D)));
        DoubleVector m = mantissa.or(LongVector.broadcast(L, PowerFunction.ONE).blend(PowerFunction.HALF, upper)).reinterpretAsDoubles();
        DoubleVector s = m.sub(1).div(m.add(1));
        DoubleVector z = s.mul(s);
        DoubleVector series = z.mul(1.0 / 19).add(1.0 / 17);
        series = series.mul(z).add(1.0 / 15);
        series = series.mul(z).add(1.0 / 13);
        series = series.mul(z).add(1.0 / 11);
        series = series.mul(z).add(1.0 / 9);
        series = series.mul(z).add(1.0 / 7);
        series = series.mul(z).add(1.0 / 5);
        series = series.mul(z).add(1.0 / 3);
        series = series.mul(z).add(1.0);
        DoubleVector p = exponent.add(s.mul(PowerFunction.LOG2_E_TWICE).mul(series)).mul(n);
        DoubleVector zero = DoubleVector.broadcast(D, n == 0 ? 0 : Double.NEGATIVE_INFINITY);
        zero.blend(p, normal).intoArray(values, i);
    }

    /** Replaces p by 2^p, and −∞ by 0. */
    private static void exponential(double[] values, int i) {
        DoubleVector given = DoubleVector.fromArray(D, values, i);
        VectorMask<Double> none = given.compare(VectorOperators.EQ, Double.NEGATIVE_INFINITY);
        exponential(given).blend(0, none).intoArray(values, i);
    }

    /** Returns 2^p; p is at most 0. */
    static DoubleVector exponential(DoubleVector given) {
        DoubleVector p = given.blend(PowerFunction.MIN_EXPONENT, given.compare(VectorOperators.LT, PowerFunction.MIN_EXPONENT));
        DoubleVector rounded = p.add(PowerFunction.ROUND).sub(PowerFunction.ROUND);
        DoubleVector y = p.sub(rounded).mul(PowerFunction.LN2);
        DoubleVector e = y.mul(1.0 / 479001600).add(1.0 / 39916800);
        e = e.mul(y).add(1.0 / 3628800);
        e = e.mul(y).add(1.0 / 362880);
        e = e.mul(y).add(1.0 / 40320);
        e = e.mul(y).add(1.0 / 5040);
        e = e.mul(y).add(1.0 / 720);
        e = e.mul(y).add(1.0 / 120);
        e = e.mul(y).add(1.0 / 24);
        e = e.mul(y).add(1.0 / 6);
        e = e.mul(y).add(0.5);
        e = e.mul(y).add(1);
        e = e.mul(y).add(1);
        // whole + 1023 as an integer, by the inverse of that method.
        DoubleVector scale = rounded.add(1023).add(0x1p52).reinterpretAsLongs().lanewise(VectorOperators.LSHL, 52).reinterpretAsDoubles();
        return e.mul(scale);
    }
}
