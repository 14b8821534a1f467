package lightning.sample;

import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.RandomDistribution;
import net.jqwik.api.Tuple;

/** Numbers, vectors and colors: short ones, which meet each other exactly, and ones with many digits. */
final class NumberArbitraries {
    /** The power of ten below the least float: nothing is left of such numbers, and little of the squares of some larger ones. */
    static final double MIN_EXPONENT = -46;

    private NumberArbitraries() {}

    /** Numbers of a range, spread evenly; only short ones get plainer in the search for the plainest failure. */
    static Arbitrary<Double> range(double min, double max) {
        int steps = 20;
        return Arbitraries.frequencyOf(
                Tuple.of(1, Arbitraries.integers().between(0, steps).withDistribution(RandomDistribution.uniform())
                        .map(i -> min + (max - min) * i / steps).withoutEdgeCases()),
                Tuple.of(3, Arbitraries.randomValue(random -> min + (max - min) * random.nextDouble())));
    }

    /** Ten to a power of a range: each magnitude is as likely as any other. */
    static Arbitrary<Double> powers(double min, double max) {
        return range(min, max).map(exponent -> Math.pow(10, exponent));
    }

    /** Mostly numbers of a range, sometimes one of the given. */
    static Arbitrary<Double> rangeOrSpecial(double min, double max, Double... special) {
        return Arbitraries.frequencyOf(Tuple.of(2, range(min, max)), Tuple.of(1, Arbitraries.of(special)));
    }

    static Arbitrary<Vec3> vectors(Arbitrary<Double> x, Arbitrary<Double> y, Arbitrary<Double> z) {
        return Combinators.combine(x, y, z).as(Vec3::new);
    }

    static Arbitrary<Vec3> vectors(double min, double max) {
        return vectors(range(min, max), range(min, max), range(min, max));
    }

    /** Colors of channels 0…1: black, white, pure and mixed ones. */
    static Arbitrary<Rgb> colors() {
        Arbitrary<Double> channel = rangeOrSpecial(0, 1, 0.0, 1.0);
        return Arbitraries.frequencyOf(
                Tuple.of(1, Arbitraries.of(Rgb.BLACK)),
                Tuple.of(2, Arbitraries.of(Rgb.WHITE)),
                Tuple.of(6, Combinators.combine(channel, channel, channel).as(Rgb::new)));
    }
}
