package lightning.scene.sky;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.data.Percentage.withPercentage;

import java.util.Arrays;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.scene.asset.EnvironmentLight;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.value.DomeRotation;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SkyTest {
    private static final Sky NOON = Sky.NONE.withOn(true).withElevation(60);

    private static SkyRadiance radiance(double turbidity, double elevation) {
        double[] ground = new double[SolarSpectrum.BANDS];
        Arrays.fill(ground, 0.3);
        var air = new Atmosphere(turbidity);
        return new SkyRadiance(air, new MultipleScattering(air, ground), Math.toRadians(elevation));
    }

    private static double luminance(SkyRadiance sky, double elevation, double azimuth) {
        double[] to = new double[3];
        sky.write(Math.sin(Math.toRadians(elevation)), Math.toRadians(azimuth), to);
        return new Rgb(to[0], to[1], to[2]).luminance();
    }

    /** The solar illuminance constant is 128 to 134 klx, depending on the spectrum. */
    @Test
    void sunOutsideOfTheAir_hasItsKnownIlluminance() {
        double[] all = new double[SolarSpectrum.BANDS];
        Arrays.fill(all, 1);
        assertThat(SolarSpectrum.color(all).luminance()).isBetween(128_000.0, 134_000.0);
    }

    /** A vertical column of air that thins out exponentially is as long as the height of its scale. */
    @Test
    void verticalColumns_areTheScaleHeights() {
        double[] to = new double[Atmosphere.COLUMNS];
        assertThat(SunColumns.TABLE.write(Atmosphere.GROUND, 1, to)).isTrue();
        assertThat(to[0]).isCloseTo(8000, withPercentage(0.2));
        assertThat(to[1]).isCloseTo(1200, withPercentage(1));
        assertThat(to[2]).isCloseTo(15_000, withPercentage(0.2));
    }

    /** Kasten and Young (1989) found 37.9 times the vertical air toward the horizon, and 10.3 times at 5 degrees. */
    @Test
    void airMass_isThatOfKastenAndYoung() {
        double[] vertical = new double[Atmosphere.COLUMNS];
        double[] low = new double[Atmosphere.COLUMNS];
        SunColumns.TABLE.write(Atmosphere.GROUND, 1, vertical);
        SunColumns.TABLE.write(Atmosphere.GROUND, Math.sin(Math.toRadians(5)), low);
        assertThat(low[0] / vertical[0]).isCloseTo(10.3, withPercentage(3));
        SunColumns.TABLE.write(Atmosphere.GROUND, 0, low);
        // Without refraction, which bends low rays.
        assertThat(low[0] / vertical[0]).isCloseTo(37.9, withPercentage(10));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 2, 5, 10})
    void higherSun_isBrighterAndLessRed(double turbidity) {
        SkyRadiance low = radiance(turbidity, 10);
        SkyRadiance high = radiance(turbidity, 60);
        assertThat(high.sun.luminance()).isGreaterThan(low.sun.luminance());
        assertThat(high.sun.r() / high.sun.b()).isLessThan(low.sun.r() / low.sun.b());
    }

    @ParameterizedTest
    @ValueSource(doubles = {5, 30, 60, 90})
    void sunAndSky_areNoBrighterThanTheSunOutside(double elevation) {
        double[] all = new double[SolarSpectrum.BANDS];
        Arrays.fill(all, 1);
        double outside = SolarSpectrum.color(all).luminance() * Math.sin(Math.toRadians(elevation));
        for (double turbidity = 1; turbidity <= 10; turbidity += 3) {
            SkyRadiance sky = radiance(turbidity, elevation);
            double onGround = sky.skylight.luminance() + sky.sun.luminance() * Math.sin(Math.toRadians(elevation));
            // The ground reflects 0.3 of it, some of which the air sends back.
            assertThat(onGround).isLessThan(outside * 1.15);
        }
    }

    /** On a clear day, illuminances of 70 to 90 klx of the sun and 7 to 15 klx of the sky are measured at 30 degrees. */
    @Test
    void clearDay_isAsBrightAsMeasured() {
        SkyRadiance sky = radiance(2, 30);
        assertThat(sky.sun.luminance()).isBetween(70_000.0, 90_000.0);
        assertThat(sky.skylight.luminance()).isBetween(7_000.0, 15_000.0);
    }

    @Test
    void zenith_isBlue_andTheHorizonBrighter() {
        SkyRadiance sky = radiance(2, 30);
        double[] zenith = new double[3];
        sky.write(1, 0, zenith);
        assertThat(zenith[2]).isGreaterThan(1.5 * zenith[0]);
        assertThat(luminance(sky, 5, 180)).isGreaterThan(2 * luminance(sky, 90, 180));
    }

    @Property(tries = 30)
    void sky_isTheSameOnBothSidesOfTheSun(@ForAll @DoubleRange(min = 0, max = 90) double elevation,
            @ForAll @DoubleRange(min = 0, max = 180) double azimuth) {
        SkyRadiance sky = radiance(2, 30);
        assertThat(luminance(sky, elevation, azimuth)).isEqualTo(luminance(sky, elevation, -azimuth));
    }

    @Test
    void azimuth_turnsTheSkyAsRotationDoes() {
        EnvironmentMap east = NOON.withAzimuth(90).environment().map();
        EnvironmentMap north = NOON.withAzimuth(0).environment().map();
        double[] a = new double[3];
        double[] b = new double[3];
        for (double[] d : new double[][] {{0.6, 0.8, 0}, {0, 0.6, 0.8}, {-0.48, 0.64, 0.6}}) {
            east.radiance(d[0], d[1], d[2], DomeRotation.NONE, a);
            // A positive rotation about y turns north to the west.
            north.radiance(d[0], d[1], d[2], DomeRotation.of(-90, 0, 0), b);
            assertThat(a).containsExactly(b, within(1e-4));
        }
    }

    @Test
    void disc_hasTheLightOfTheSun() {
        EnvironmentMap map = NOON.withSunRadius(2).environment().map();
        EnvironmentLight light = map.brightLights(16).getFirst();
        Vec3 d = light.direction();
        double[] inside = new double[3];
        double[] outside = new double[3];
        map.radiance(d.x(), d.y(), d.z(), DomeRotation.NONE, inside);
        map.smoothRadiance(d.x(), d.y(), d.z(), DomeRotation.NONE, outside);
        double sin = Math.sin(Math.toRadians(2));
        assertThat(map.brightLights(16)).hasSize(1);
        // White paper that faces it has its irradiance over π.
        assertThat((inside[0] - outside[0]) * sin * sin).isCloseTo(light.red() * light.meanLength(), withPercentage(1e-6));
    }

    @Test
    void sunBelowTheHorizon_isDark_butTheSkyIsNot() {
        SkyRadiance dusk = radiance(2, -3);
        assertThat(dusk.sun).isEqualTo(Rgb.BLACK);
        assertThat(dusk.skylight.luminance()).isBetween(1.0, 1000.0);
    }

    @Test
    void sameSky_isTheSameObject() {
        assertThat(NOON.environment()).isSameAs(NOON.withOn(false).environment());
    }
}
