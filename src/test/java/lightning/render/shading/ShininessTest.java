package lightning.render.shading;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.List;
import java.util.Random;
import lightning.base.math.PowerFunction;
import lightning.base.math.Vec3;
import lightning.sample.Slow;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

/** Tests highlights at every shininess against 60-digit arithmetic. */
class ShininessTest {
    private static final MathContext DIGITS = new MathContext(60);
    /** Tolerance of the cosine between V and R: eight units in the last place of 1. */
    private static final BigDecimal COSINE = new BigDecimal(0x1p-49);
    /** Half a unit in a float's last place, for normal and for tiny values. */
    private static final BigDecimal FLOAT = new BigDecimal(0x1p-24);
    private static final BigDecimal TINY = new BigDecimal(Float.MIN_VALUE).divide(BigDecimal.TWO);

    /** Row with a light near to or far from its mirror direction; all numbers are exact. */
    private record Highlight(Vec3 n, Vec3 v, Vec3 p, Vec3 light) {

        static Highlight of(Random random) {
            Vec3 n = floats(direction(random));
            Vec3 v = floats(direction(random));
            v = v.dot(n) > 0 ? v.negated() : v;
            Vec3 mirrored = v.minus(n.times(2 * v.dot(n)));
            double off = switch (random.nextInt(8)) {
                case 0 -> 0;
                case 1 -> 1;
                default -> Math.pow(10, -8 * random.nextDouble());
            };
            Vec3 p = floats(direction(random).times(5));
            return new Highlight(n, v, p,
                    p.plus(mirrored.plus(direction(random).times(off)).times(Math.pow(10, 4 * random.nextDouble() - 2))));
        }

        private static Vec3 direction(Random random) {
            return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalized();
        }

        private static Vec3 floats(Vec3 v) {
            return new Vec3((float) v.x(), (float) v.y(), (float) v.z());
        }

        float specular(double shininess) {
            Light source = Light.of("l", LightType.POINT).withPosition(light);
            Camera atOrigin = new Camera(Vec3.ZERO, new Vec3(0, 0, -1), Vec3.Y, 40);
            Scene scene = new Scene(PictureSettings.DEFAULT, atOrigin, World.DEFAULT, List.of(), List.of(), List.of(source));
            LightingEquation equation = new LightingEquation(LightSource.of(source, scene));
            equation.moveTo((float) p.x(), (float) p.y(), (float) p.z(), (float) n.x(), (float) n.y(), (float) n.z());
            return equation.specular((float) n.x(), (float) n.y(), (float) n.z(), (float) v.x(), (float) v.y(), (float) v.z(), shininess);
        }

        /** Returns V·R between unit vectors, R = L − 2(N·L)N, at least 0. */
        BigDecimal cosine() {
            BigDecimal[] normal = exact(n);
            BigDecimal[] view = exact(v);
            BigDecimal[] to = exact(light);
            BigDecimal[] from = exact(p);
            for (int i = 0; i < 3; i++) {
                to[i] = to[i].subtract(from[i]);
            }
            BigDecimal twice = dot(normal, to).multiply(BigDecimal.TWO);
            for (int i = 0; i < 3; i++) {
                to[i] = to[i].subtract(twice.multiply(normal[i]));
            }
            BigDecimal lengths = dot(view, view).multiply(dot(to, to)).sqrt(DIGITS);
            return dot(view, to).divide(lengths, DIGITS).max(BigDecimal.ZERO);
        }

        private static BigDecimal[] exact(Vec3 v) {
            return new BigDecimal[] {new BigDecimal(v.x()), new BigDecimal(v.y()), new BigDecimal(v.z())};
        }

        private static BigDecimal dot(BigDecimal[] a, BigDecimal[] b) {
            return a[0].multiply(b[0]).add(a[1].multiply(b[1])).add(a[2].multiply(b[2]));
        }
    }

    /** Returns a power with an integer or half-integer exponent. */
    private static BigDecimal power(BigDecimal x, double n) {
        BigDecimal whole = x.pow((int) n, DIGITS);
        return n == Math.rint(n) ? whole : whole.multiply(x.sqrt(DIGITS), DIGITS);
    }

    @Provide
    Arbitrary<Double> shininess() {
        return Arbitraries.of(0.0, 0.5, 1.0, 2.0, 7.5, 16.0, 100.0, 1e3, 12345.5, 1e5, 1e6);
    }

    @Property(edgeCases = EdgeCasesMode.NONE)
    void highlight_matchesExactPowerOfCosine(@ForAll("shininess") double shininess, @ForAll Random random) {
        for (int n = 0; n < 10; n++) {
            Highlight highlight = Highlight.of(random);
            BigDecimal cosine = highlight.cosine();
            assertWithin(new BigDecimal(highlight.specular(shininess)), cosine, shininess, highlight);
        }
    }

    private static void assertWithin(BigDecimal actual, BigDecimal cosine, double shininess, Highlight highlight) {
        assertThat(actual).as("%s, shininess %s", highlight, shininess).isBetween(lowerBound(cosine, shininess),
                upperBound(cosine, shininess));
    }

    private static BigDecimal lowerBound(BigDecimal cosine, double shininess) {
        BigDecimal low = power(cosine.subtract(COSINE).max(BigDecimal.ZERO), shininess);
        return low.subtract(low.multiply(FLOAT)).subtract(TINY);
    }

    private static BigDecimal upperBound(BigDecimal cosine, double shininess) {
        BigDecimal high = power(cosine.add(COSINE).min(BigDecimal.ONE), shininess);
        return high.add(high.multiply(FLOAT)).add(TINY);
    }

    /** Counterexample: N and V are floats, and the high exponent amplifies their length errors a million times. */
    @Test
    @Slow
    void unnormalizedVectors_makeHighlightWrongByPercents() {
        Random random = new Random(1);
        int wrong = 0;
        for (int n = 0; n < 1000; n++) {
            Highlight h = Highlight.of(random);
            Vec3 l = h.light.minus(h.p).normalized();
            double dot = h.v.dot(l.minus(h.n.times(2 * h.n.dot(l))));
            float textbook = (float) PowerFunction.pow(Math.clamp(dot, 0, 1), 1e6);
            BigDecimal cosine = h.cosine();
            boolean within = new BigDecimal(textbook).compareTo(lowerBound(cosine, 1e6)) >= 0
                    && new BigDecimal(textbook).compareTo(upperBound(cosine, 1e6)) <= 0;
            wrong += within ? 0 : 1;
        }
        assertThat(wrong).as("highlights off among 1000").isGreaterThan(50);
    }

    /** V·R is 0 or less: 0⁰ = 1, and 0 to any other power is 0. */
    @Property
    void rowMirroringElsewhere_hasHighlightOnlyAtShininessZero(@ForAll("shininess") double shininess) {
        for (Vec3 v : new Vec3[] {new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0.6f, 0.8f, 0)}) {
            Highlight away = new Highlight(Vec3.Y, v, Vec3.ZERO, new Vec3(0, 3, 0));
            assertThat(away.specular(shininess)).as("%s", v).isEqualTo(shininess == 0 ? 1 : 0);
        }
    }
}
