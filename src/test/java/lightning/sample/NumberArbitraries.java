package lightning.sample;

import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.RandomDistribution;
import net.jqwik.api.Tuple;

/** Arbitrary numbers, vectors and colors: short ones, which often coincide exactly, and ones with many digits. */
final class NumberArbitraries {
    /** Power of ten below the smallest float: such numbers underflow, as do the squares of somewhat larger ones. */
    static final double MIN_EXPONENT = -46;

    private NumberArbitraries() {}

    /** Returns numbers of a range with uniform distribution; only short ones shrink. */
    static Arbitrary<Double> range(double min, double max) {
        int steps = 20;
        return Arbitraries.frequencyOf(
                Tuple.of(1, Arbitraries.integers().between(0, steps).withDistribution(RandomDistribution.uniform())
                        .map(i -> min + (max - min) * i / steps).withoutEdgeCases()),
                Tuple.of(3, Arbitraries.randomValue(random -> min + (max - min) * random.nextDouble())));
    }

    /** Returns powers of ten: each magnitude in the range is equally likely. */
    static Arbitrary<Double> powers(double min, double max) {
        return range(min, max).map(exponent -> Math.pow(10, exponent));
    }

    /** Returns mostly numbers of a range, sometimes a special value. */
    static Arbitrary<Double> rangeOrSpecial(double min, double max, Double... special) {
        return Arbitraries.frequencyOf(Tuple.of(2, range(min, max)), Tuple.of(1, Arbitraries.of(special)));
    }

    static Arbitrary<Vec3> vectors(Arbitrary<Double> x, Arbitrary<Double> y, Arbitrary<Double> z) {
        return Combinators.combine(x, y, z).as(Vec3::new);
    }

    static Arbitrary<Vec3> vectors(double min, double max) {
        return vectors(range(min, max), range(min, max), range(min, max));
    }

    /** Returns colors with channels 0…1: black, white, pure and mixed ones. */
    static Arbitrary<Rgb> colors() {
        Arbitrary<Double> channel = rangeOrSpecial(0, 1, 0.0, 1.0);
        return Arbitraries.frequencyOf(
                Tuple.of(1, Arbitraries.of(Rgb.BLACK)),
                Tuple.of(2, Arbitraries.of(Rgb.WHITE)),
                Tuple.of(6, Combinators.combine(channel, channel, channel).as(Rgb::new)));
    }
}
