package lightning.render.lobe;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests directions of rough reflections and their albedo against integrals over the sphere. */
class ReflectionLobeTest {
    private static final int STEPS = 400;

    @ParameterizedTest
    @CsvSource({"1, 0.3", "0.7, 0.3", "0.3, 0.5", "0.5, 1", "0.9, 0.1"})
    void density_integratesToOneOverTheSphere(double cosine, double alpha) {
        var lobe = new ReflectionLobe();
        lobe.aim(cosine, alpha);
        assertThat(overSphere(lobe, -1, () -> 1)).isCloseTo(1, within(0.003));
    }

    @ParameterizedTest
    @CsvSource({"1, 0.3, 0.2, 0", "0.7, 0.6, 0.2, 30", "0.3, 0.9, 0.3, 90", "0.5, 1, 0.4, -70"})
    void stretchedDensity_integratesToOneOverTheSphere(double cosine, double along, double across, double angle) {
        var lobe = stretched(cosine, along, across, angle);
        assertThat(overSphere(lobe, -1, () -> 1)).isCloseTo(1, within(0.003));
    }

    @ParameterizedTest
    @CsvSource({"1, 0.3, 0.2, 0", "0.7, 0.6, 0.2, 30", "0.3, 0.9, 0.3, 90", "0.5, 1, 0.4, -70"})
    void stretchedRays_haveTheMeanOfTheirDensity(double cosine, double along, double across, double angle) {
        var lobe = stretched(cosine, along, across, angle);
        double x = overSphere(lobe, -1, lobe::x);
        double y = overSphere(lobe, -1, lobe::y);
        double weight = overSphere(lobe, -1, lobe::weight);
        double[] mean = new double[3];
        for (int i = 0; i < STEPS; i++) {
            for (int j = 0; j < STEPS; j++) {
                double turn = 2 * Math.PI * (j + 0.5) / STEPS;
                lobe.reflect((i + 0.5) / STEPS, Math.cos(turn), Math.sin(turn));
                mean[0] += lobe.x();
                mean[1] += lobe.y();
                mean[2] += lobe.weight();
            }
        }
        double rays = STEPS * (double) STEPS;
        assertThat(mean[0] / rays).isCloseTo(x, within(0.005));
        assertThat(mean[1] / rays).isCloseTo(y, within(0.005));
        assertThat(mean[2] / rays).isCloseTo(weight, within(0.005));
    }

    @ParameterizedTest
    @CsvSource({"1, 0.3", "0.7, 0.3", "0.3, 0.5", "0.9, 0.1"})
    void equalWidths_reflectAsOne(double cosine, double alpha) {
        var round = new ReflectionLobe();
        round.aim(cosine, alpha);
        var lobe = stretched(cosine, alpha, alpha, 40);
        double[][] directions = {{0.6, 0, 0.8}, {0, 0.6, 0.8}, {-0.48, 0.36, 0.8}, {0, 0, 1}};
        for (double[] d : directions) {
            round.moveTo(d[0], d[1], d[2]);
            lobe.moveTo(d[0], d[1], d[2]);
            assertThat(lobe.density()).isCloseTo(round.density(), within(1e-9 * round.density()));
            assertThat(lobe.weight()).isCloseTo(round.weight(), within(1e-12));
            assertThat(lobe.schlick()).isCloseTo(round.schlick(), within(1e-12));
        }
    }

    @Test
    void rays_areWiderAlongTheDirection() {
        var lobe = stretched(1, 0.5, 0.1, 90);
        double x = overSphere(lobe, -1, () -> lobe.x() * lobe.x());
        double y = overSphere(lobe, -1, () -> lobe.y() * lobe.y());
        assertThat(y).isGreaterThan(5 * x);
    }

    private static ReflectionLobe stretched(double cosine, double along, double across, double degrees) {
        var lobe = new ReflectionLobe();
        double angle = Math.toRadians(degrees);
        lobe.aim(cosine, along, across, Math.cos(angle), Math.sin(angle));
        return lobe;
    }

    @ParameterizedTest
    @CsvSource({"1, 0.5", "0.7, 0.5", "0.3, 0.7", "0.5, 1", "0.9, 0.3"})
    void albedo_isTheIntegralOfTheLobe(double cosine, double roughness) {
        var lobe = new ReflectionLobe();
        lobe.aim(cosine, roughness * roughness);
        double colored = overSphere(lobe, 0, () -> lobe.weight() * (1 - lobe.schlick()));
        double grazing = overSphere(lobe, 0, () -> lobe.weight() * lobe.schlick());
        assertThat((double) DirectionalAlbedo.ofF0((float) cosine, (float) roughness)).isCloseTo(colored, within(0.01));
        assertThat((double) DirectionalAlbedo.grazing((float) cosine, (float) roughness)).isCloseTo(grazing, within(0.01));
    }

    @ParameterizedTest
    @CsvSource({"1", "0.8", "0.4", "0.1"})
    void albedoOfSmoothSurface_isSchlicksFresnelTerm(double cosine) {
        double fresnel = Math.pow(1 - cosine, 5);
        assertThat((double) DirectionalAlbedo.ofF0((float) cosine, 0)).isCloseTo(1 - fresnel, within(0.01));
        assertThat((double) DirectionalAlbedo.grazing((float) cosine, 0)).isCloseTo(fresnel, within(0.01));
    }

    @Test
    void albedo_isAtLeastAQuarter() {
        for (float cosine = 0; cosine <= 1; cosine += 1 / 128f) {
            for (float roughness = 0; roughness <= 1; roughness += 1 / 128f) {
                assertThat(DirectionalAlbedo.ofF0(cosine, roughness) + DirectionalAlbedo.grazing(cosine, roughness)).isGreaterThan(0.25f);
            }
        }
    }

    private interface Value {
        double at();
    }

    /** Returns the integral of density times value over the directions with at least this z. */
    private static double overSphere(ReflectionLobe lobe, double minZ, Value value) {
        double sum = 0;
        for (int i = 0; i < STEPS; i++) {
            double z = minZ + (1 - minZ) * (i + 0.5) / STEPS;
            double radius = Math.sqrt(1 - z * z);
            for (int j = 0; j < STEPS; j++) {
                double angle = 2 * Math.PI * (j + 0.5) / STEPS;
                lobe.moveTo(radius * Math.cos(angle), radius * Math.sin(angle), z);
                sum += lobe.density() * value.at();
            }
        }
        return sum * (1 - minZ) * 2 * Math.PI / (STEPS * (double) STEPS);
    }
}
