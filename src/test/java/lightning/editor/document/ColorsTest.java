package lightning.editor.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import lightning.base.math.Rgb;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class ColorsTest {
    @Test
    void pureColors_areSixtyDegreesApart() {
        assertThat(HsvColor.of(new Rgb(1, 0, 0))).isEqualTo(new HsvColor(0, 1, 1));
        assertThat(HsvColor.of(new Rgb(2, 2, 0))).isEqualTo(new HsvColor(60, 1, 2));
        assertThat(HsvColor.of(new Rgb(0, 1, 0))).isEqualTo(new HsvColor(120, 1, 1));
        assertThat(HsvColor.of(new Rgb(0, 0, 0.5))).isEqualTo(new HsvColor(240, 1, 0.5));
        assertThat(HsvColor.of(new Rgb(1, 0, 1))).isEqualTo(new HsvColor(300, 1, 1));
    }

    @Test
    void grays_haveNoHueAndNoSaturation() {
        assertThat(HsvColor.of(Rgb.gray(0.3))).isEqualTo(new HsvColor(0, 0, 0.3));
        assertThat(HsvColor.of(Rgb.BLACK)).isEqualTo(new HsvColor(0, 0, 0));
    }

    @Property
    void colorThroughHsv_comesBack(@ForAll @DoubleRange(max = 5) double r, @ForAll @DoubleRange(max = 5) double g,
            @ForAll @DoubleRange(max = 5) double b) {
        Rgb back = HsvColor.of(new Rgb(r, g, b)).rgb();
        assertThat(back.r()).isCloseTo(r, within(1e-12));
        assertThat(back.g()).isCloseTo(g, within(1e-12));
        assertThat(back.b()).isCloseTo(b, within(1e-12));
    }

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
}
