package lightning.render.gather.glow;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.SplittableRandom;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.trace.Geometry;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the light of small glowing objects at a point against form factors. */
class GlowAimTest {
    private static final int SEEDS = 40_000;

    private static GlowShapes shapes(String shapes) throws JenException {
        return GlowShapes.of(Geometry.of(JenReader.read("""
                jen 1
                camera { from 0 0 0  to 0 0 -1 }
                material lamp { glow 1 1 1 }
                material glass { glow 1 1 1  clear 1 1 1 }
                material dark { glow 0 0 0 }
                """ + shapes, "lamps.jen", Path.of("")).scene()));
    }

    /** A sphere above the horizon covers the share r²/d²·cos θ of a hemisphere weighted by cosines, whatever its distance. */
    @ParameterizedTest
    @CsvSource({"0, 0, 5, 1, 64", "3, 1, 2, 0.5, 64", "-20, 10, 4, 2, 1", "0, 0.3, -5, 1, 64"})
    void raysAtSphere_addUpToItsFormFactor(double x, double y, double z, double radius, int rays) throws JenException {
        GlowAim aim = new GlowAim(
                shapes("sphere lamp { material lamp  at " + x + " " + y + " " + z + "  scale " + radius + " " + radius + " " + radius
                        + " }"),
                rays);
        double distance = Math.sqrt(x * x + y * y + z * z);
        double sign = Math.signum(z);
        double expected = radius * radius / (distance * distance) * sign * z / distance;
        double sum = 0;
        double squares = 0;
        SplittableRandom random = new SplittableRandom(7);
        for (int i = 0; i < SEEDS; i++) {
            double share = 0;
            long seed = random.nextLong();
            for (int k = 0; k < aim.rays(0, seed, 0, 0, 0); k++) {
                double[] d = new double[3];
                double angle = aim.aim(0, k, seed, 0, 0, 0, d);
                double along = d[0] * x + d[1] * y + d[2] * z;
                boolean hits = along > 0 && distance * distance - along * along < radius * radius;
                share += hits ? angle * sign * d[2] : 0;
            }
            sum += share;
            squares += share * share;
        }
        double mean = sum / SEEDS;
        double deviation = Math.sqrt((squares / SEEDS - mean * mean) / SEEDS);
        assertThat(mean).isCloseTo(expected, within(4 * deviation + 1e-6));
        assertThat(deviation).isLessThan(0.02 * expected);
    }

    /** With four times as many objects as rays, a quarter of the points aim at each, and their rays count four times. */
    @Test
    void raysAtManyObjects_takeTurns() throws JenException {
        StringBuilder lamps = new StringBuilder();
        for (int i = 0; i < 64; i++) {
            lamps.append("sphere lamp_").append(i).append(" { material lamp  at ").append(i - 32).append(" 0 100 }\n");
        }
        GlowAim aim = new GlowAim(shapes(lamps.toString()), 16);
        GlowAim dense = new GlowAim(shapes(lamps.toString()), 64);
        SplittableRandom random = new SplittableRandom(3);
        int[] rays = new int[64];
        for (int i = 0; i < SEEDS; i++) {
            long seed = random.nextLong();
            for (int shape = 0; shape < 64; shape++) {
                rays[shape] += aim.rays(shape, seed, 0, 0, 0);
                assertThat(aim.aim(shape, 0, seed, 0, 0, 0, new double[3]))
                        .isEqualTo(4 * dense.aim(shape, 0, seed, 0, 0, 0, new double[3]));
            }
        }
        for (int count : rays) {
            assertThat((double) count).isCloseTo(SEEDS / 4.0, within(5 * Math.sqrt(SEEDS * 3 / 16.0)));
        }
    }

    @Test
    void shapes_areOpaqueObjectsThatGlow() throws JenException {
        GlowShapes shapes = shapes("""
                sphere none { material dark  at 0 0 9 }
                sphere pane { material glass  at 0 4 9 }
                sphere lamp { material lamp  at 0 -4 9 }
                """);
        assertThat(shapes.count()).isEqualTo(1);
        assertThat(shapes.primitive(0)).isEqualTo(2);
    }

    @Test
    void largeObject_isNotAimedAt() throws JenException {
        GlowShapes shapes = shapes("sphere lamp { material lamp  at 0 0 9  scale 3 3 3 }");
        assertThat(shapes.isAimed(0, 0, 0, 0)).isFalse();
        assertThat(shapes.isAimed(0, 0, 0, -9)).isTrue();
        assertThat(shapes.isAimed(1, 0, 0, -9)).isFalse();
    }

    @Test
    void tooManyObjects_areNotAimedAt() throws JenException {
        StringBuilder lamps = new StringBuilder();
        for (int i = 0; i <= 1024; i++) {
            lamps.append("sphere lamp_").append(i).append(" { material lamp  at ").append(i).append(" 0 9 }\n");
        }
        GlowShapes many = shapes(lamps.toString());
        assertThat(many.count()).isZero();
        assertThat(many.contain(GlowShapes.none())).isFalse();
        assertThat(GlowShapes.none().contain(many)).isFalse();
    }
}
