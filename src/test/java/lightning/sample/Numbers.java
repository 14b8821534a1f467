package lightning.sample;

import java.math.BigDecimal;
import lightning.math.Rgb;
import lightning.math.Vec3;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.RandomDistribution;
import net.jqwik.api.Tuple;

/** Numbers, vectors and colours: short ones, which meet each other exactly, and ones with many digits. */
final class Numbers {
    private Numbers() {}

    /** Numbers of a range, spread evenly. */
    static Arbitrary<Double> between(double min, double max) {
        return Arbitraries.frequencyOf(
                Tuple.of(1, scaled(min, max, 1)),
                Tuple.of(3, scaled(min, max, 9)));
    }

    private static Arbitrary<Double> scaled(double min, double max, int digits) {
        double target = min <= 0 && max >= 0 ? 0 : min;
        return Arbitraries.bigDecimals().between(BigDecimal.valueOf(min), BigDecimal.valueOf(max)).ofScale(digits)
                .withDistribution(RandomDistribution.uniform()).shrinkTowards(BigDecimal.valueOf(target))
                .map(BigDecimal::doubleValue).withoutEdgeCases();
    }

    /** Mostly numbers of a range, sometimes one of the given. */
    static Arbitrary<Double> betweenOr(double min, double max, Double... special) {
        return Arbitraries.frequencyOf(Tuple.of(2, between(min, max)), Tuple.of(1, Arbitraries.of(special)));
    }

    static Arbitrary<Vec3> vectors(Arbitrary<Double> x, Arbitrary<Double> y, Arbitrary<Double> z) {
        return Combinators.combine(x, y, z).as(Vec3::new);
    }

    static Arbitrary<Vec3> vectors(double min, double max) {
        return vectors(between(min, max), between(min, max), between(min, max));
    }

    /** Colours of channels 0…1: black, white, pure and mixed ones. */
    static Arbitrary<Rgb> colors() {
        Arbitrary<Double> channel = betweenOr(0, 1, 0.0, 1.0);
        return Arbitraries.frequencyOf(
                Tuple.of(1, Arbitraries.of(Rgb.BLACK)),
                Tuple.of(2, Arbitraries.of(Rgb.WHITE)),
                Tuple.of(6, Combinators.combine(channel, channel, channel).as(Rgb::new)));
    }
}
