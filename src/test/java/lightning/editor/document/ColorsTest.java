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
    void pureColors_standEverySixtyDegrees() {
        assertThat(Hsv.of(new Rgb(1, 0, 0))).isEqualTo(new Hsv(0, 1, 1));
        assertThat(Hsv.of(new Rgb(2, 2, 0))).isEqualTo(new Hsv(60, 1, 2));
        assertThat(Hsv.of(new Rgb(0, 1, 0))).isEqualTo(new Hsv(120, 1, 1));
        assertThat(Hsv.of(new Rgb(0, 0, 0.5))).isEqualTo(new Hsv(240, 1, 0.5));
        assertThat(Hsv.of(new Rgb(1, 0, 1))).isEqualTo(new Hsv(300, 1, 1));
    }

    @Test
    void greys_haveNoHueAndNoSaturation() {
        assertThat(Hsv.of(Rgb.grey(0.3))).isEqualTo(new Hsv(0, 0, 0.3));
        assertThat(Hsv.of(Rgb.BLACK)).isEqualTo(new Hsv(0, 0, 0));
    }

    @Property
    void colorThroughHsv_comesBack(@ForAll @DoubleRange(max = 5) double r, @ForAll @DoubleRange(max = 5) double g,
            @ForAll @DoubleRange(max = 5) double b) {
        Rgb back = Hsv.of(new Rgb(r, g, b)).rgb();
        assertThat(back.r()).isCloseTo(r, within(1e-12));
        assertThat(back.g()).isCloseTo(g, within(1e-12));
        assertThat(back.b()).isCloseTo(b, within(1e-12));
    }

    /** CIE illuminant A, the tungsten lamp: x 0.44757, y 0.40745 at 2856 K. */
    @Test
    void tungsten_isIlluminantA() {
        double x = Kelvin.x(2856);
        assertThat(x).isCloseTo(0.44757, within(1e-3));
        assertThat(Kelvin.y(2856, x)).isCloseTo(0.40745, within(1e-3));
    }

    /** The Planckian locus at 6500 K: x 0.3135, y 0.3237 (Wyszecki and Stiles). */
    @Test
    void daylightTemperature_isOnTheLocus() {
        double x = Kelvin.x(6500);
        assertThat(x).isCloseTo(0.3135, within(1e-3));
        assertThat(Kelvin.y(6500, x)).isCloseTo(0.3237, within(1e-3));
    }

    @Property
    void brightestChannelOfAGlow_isOne(@ForAll @DoubleRange(min = Kelvin.MIN, max = Kelvin.MAX) double kelvin) {
        Rgb glow = Kelvin.rgb(kelvin);
        assertThat(glow.max()).isEqualTo(1);
        assertThat(glow.min()).isGreaterThanOrEqualTo(0);
    }

    @Property
    void temperatureOfAGlow_comesBack(@ForAll @DoubleRange(min = 2100, max = Kelvin.MAX) double kelvin) {
        assertThat(Kelvin.of(Kelvin.rgb(kelvin))).isCloseTo(kelvin, within(1.0));
    }

    @Test
    void temperatureOfAColorOffTheLocus_isAnEnd() {
        assertThat(Kelvin.of(new Rgb(1, 0, 0))).isEqualTo(Kelvin.MIN);
        assertThat(Kelvin.of(new Rgb(0, 0, 1))).isCloseTo(Kelvin.MAX, within(1e-6));
    }
}
