package lightning.scene.light;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** Tests flux and ranges of beams against closed forms of their integrals. */
class BeamTest {
    private static double candela(Beam beam, double dropoff) {
        Light light = Light.of("l", LightType.RECT).withBeam(beam).withDropoff(dropoff);
        return 1 / (Math.PI * IntensityUnit.LUMEN.relative(light, 1));
    }

    @Test
    void openFace_hasTheFluxOfACosine() {
        assertThat(candela(Beam.OPEN, 0)).isEqualTo(Math.PI, within(1e-12));
    }

    /** 2π times the integral of cosⁿ·sin is 2π/(n + 1). */
    @Test
    void focusedFace_hasTheFluxOfAPower() {
        assertThat(candela(Beam.OPEN, 3)).isEqualTo(2 * Math.PI / 5, within(1e-12));
    }

    /** 2π times the integral of cos·sin up to c is π·sin² c. */
    @Test
    void hardCone_hasTheFluxWithinIt() {
        assertThat(candela(Beam.OPEN.withCone(30), 0)).isEqualTo(Math.PI / 4, within(1e-7));
    }

    /** Returns the factor by which Cycles makes a light with a spread brighter, from the integral of cos θ·(1 − tan θ / tan a)·sin θ. */
    private static double gain(double a) {
        return Math.tan(a) / (Math.tan(a) - a);
    }

    /** Cycles divides the spread by this integral, so that its power stays. */
    @Test
    void spread_hasTheFluxThatItsGainRestores() {
        for (double spread : new double[] {2, 15, 45, 80}) {
            assertThat(candela(Beam.OPEN.withSpread(spread), 0) * gain(Math.toRadians(spread))).isEqualTo(Math.PI, within(1e-6));
        }
    }

    /** Two units more of cosine at the axis: a narrow focus is integrated as exactly as a wide one. */
    @Test
    void narrowFocusInAWideCone_hasTheFluxOfThePower() {
        assertThat(candela(Beam.OPEN.withCone(89), 10_000)).isEqualTo(2 * Math.PI / 10_002, within(1e-8));
    }

    @Test
    void valueOutOfRange_isNamed() {
        assertThatThrownBy(() -> Beam.OPEN.withCone(91)).hasMessageContaining("cone must be from 0 to 90");
        assertThatThrownBy(() -> Beam.OPEN.withSoftness(1.5)).hasMessageContaining("cone_softness must be from 0 to 1");
        assertThatThrownBy(() -> Beam.OPEN.withSpread(0)).hasMessageContaining("beam_spread must be from 1 to 90");
    }
}
