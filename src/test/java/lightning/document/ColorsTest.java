package lightning.document;

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
}
