package lightning.render.lobe;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests the lobe of fibers against integrals over the hemisphere and against pictures of Cycles. */
class SheenLobeTest {
    private static final int STEPS = 1000;

    @ParameterizedTest
    @CsvSource({"1, 0.3", "0.7, 0.5", "0.3, 0.8", "0.1, 0.5", "0.5, 0.2", "0.5, 1"})
    void lobe_integratesToItsAlbedo(double cosine, double roughness) {
        assertThat(overHemisphere(cosine, (nl, vl) -> SheenLobe.term(roughness, cosine, nl, vl)) / Math.PI)
                .isCloseTo(SheenLobe.albedo(roughness, (float) cosine), within(0.003));
    }

    /** Expected values are those of planes in uniform light, rendered by Cycles of Blender 5.0.1 with 16 384 samples. */
    @ParameterizedTest
    @CsvSource({"0.1, 0.3, 0.4347", "0.1, 0.5, 0.5521", "0.1, 0.8, 0.6422", "0.4, 0.3, 0.0494", "0.4, 0.5, 0.2229", "0.4, 0.8, 0.4409",
        "0.9, 0.8, 0.2061", "0.5, 1, 0.4987"})
    void albedo_isThatOfCycles(double cosine, double roughness, double expected) {
        assertThat((double) SheenLobe.albedo(roughness, (float) cosine)).isCloseTo(expected, within(0.013));
    }

    @ParameterizedTest
    @CsvSource({"1, 0.3", "0.7, 0.5", "0.1, 0.8"})
    void directions_haveTheirDensity(double cosine, double roughness) {
        var directions = new SheenDirections();
        directions.aim(roughness, cosine);
        // The mean of z over the directions is the integral of density times z.
        double mean = 0;
        int side = 300;
        for (int i = 0; i < side; i++) {
            for (int j = 0; j < side; j++) {
                double angle = 2 * Math.PI * (j + 0.5) / side;
                directions.scatter((i + 0.5) / side, Math.cos(angle), Math.sin(angle));
                mean += directions.z() / (side * (double) side);
            }
        }
        assertThat(overHemisphere(cosine, (nl, vl) -> SheenLobe.shape(roughness, cosine, nl, vl) * nl) / Math.PI).isCloseTo(mean,
                within(0.003));
    }

    @Test
    void term_isAtMostEight() {
        for (double roughness : new double[] {0, 0.2, 0.3, 0.5, 0.7, 1}) {
            for (double nv = 0; nv <= 1; nv += 1 / 64.0) {
                for (double nl = 1 / 512.0; nl <= 1; nl += 1 / 512.0) {
                    double rest = Math.sqrt((1 - nv * nv) * (1 - nl * nl));
                    for (double cos = -1; cos <= 1; cos += 1 / 16.0) {
                        assertThat(SheenLobe.term(roughness, nv, nl, nv * nl + rest * cos)).isBetween(0.0, 8.0);
                    }
                }
            }
        }
    }

    private interface Value {
        double at(double nl, double vl);
    }

    private static double overHemisphere(double cosine, Value value) {
        double sine = Math.sqrt(1 - cosine * cosine);
        double sum = 0;
        for (int i = 0; i < STEPS; i++) {
            double z = (i + 0.5) / STEPS;
            for (int j = 0; j < STEPS; j++) {
                double x = Math.sqrt(1 - z * z) * Math.cos(2 * Math.PI * (j + 0.5) / STEPS);
                sum += value.at(z, sine * x + cosine * z);
            }
        }
        return sum * 2 * Math.PI / (STEPS * (double) STEPS);
    }
}
