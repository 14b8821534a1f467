package lightning.scene.value;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import lightning.base.math.Rgb;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class ColorTemperatureTest {
    /** CIE illuminant A, the tungsten lamp: x 0.44757, y 0.40745 at 2856 K. */
    @Test
    void tungsten_isIlluminantA() {
        double x = ColorTemperature.chromaticityX(2856);
        assertThat(x).isCloseTo(0.44757, within(1e-3));
        assertThat(ColorTemperature.chromaticityY(2856, x)).isCloseTo(0.40745, within(1e-3));
    }

    /** The Planckian locus at 6500 K: x 0.3135, y 0.3237 (Wyszecki and Stiles). */
    @Test
    void daylightTemperature_isOnTheLocus() {
        double x = ColorTemperature.chromaticityX(6500);
        assertThat(x).isCloseTo(0.3135, within(1e-3));
        assertThat(ColorTemperature.chromaticityY(6500, x)).isCloseTo(0.3237, within(1e-3));
    }

    @Property
    void brightestChannel_isOne(@ForAll @DoubleRange(min = ColorTemperature.MIN, max = ColorTemperature.MAX) double kelvin) {
        Rgb glow = ColorTemperature.rgb(kelvin);
        assertThat(glow.max()).isEqualTo(1);
        assertThat(glow.min()).isGreaterThanOrEqualTo(0);
    }

    @Property
    void temperature_roundTrips(@ForAll @DoubleRange(min = 2100, max = ColorTemperature.MAX) double kelvin) {
        assertThat(ColorTemperature.of(ColorTemperature.rgb(kelvin))).isCloseTo(kelvin, within(1.0));
    }

    @Test
    void colorOffLocus_givesRangeEnd() {
        assertThat(ColorTemperature.of(new Rgb(1, 0, 0))).isEqualTo(ColorTemperature.MIN);
        assertThat(ColorTemperature.of(new Rgb(0, 0, 1))).isCloseTo(ColorTemperature.MAX, within(1e-6));
    }

    @Test
    void neutralTint_isExactlyWhite() {
        assertThat(ColorTemperature.tint(ColorTemperature.NEUTRAL)).isEqualTo(Rgb.WHITE);
        assertThat(ColorTemperature.tint(6500.001).max()).isCloseTo(1, within(1e-6));
        assertThat(ColorTemperature.tint(6500.001).min()).isCloseTo(1, within(1e-6));
    }

    @Property
    void tint_hasTheLuminanceOfWhite(@ForAll @DoubleRange(min = ColorTemperature.MIN, max = ColorTemperature.MAX) double kelvin) {
        Rgb tint = ColorTemperature.tint(kelvin);
        assertThat(0.2126 * tint.r() + 0.7152 * tint.g() + 0.0722 * tint.b()).isCloseTo(1, within(1e-12));
        assertThat(tint.r() > tint.b()).isEqualTo(kelvin < ColorTemperature.NEUTRAL);
    }
}
