package lightning.render.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.FloatRange;
import org.junit.jupiter.api.Test;

class FilmicTest {
    private static final ViewTransform VIEW = ViewTransform.DEFAULT.withCurve(DisplayCurve.FILMIC);

    @Test
    void middleGray_isHalfOfDisplay() {
        assertThat(Filmic.gray(0.18)).isCloseTo(0.5, within(1e-12));
    }

    @Test
    void ends_areBlackAndWhite() {
        assertThat(Filmic.gray(0)).isZero();
        assertThat(Filmic.gray(0.18 * Math.pow(2, -10))).isCloseTo(0, within(1e-12));
        assertThat(Filmic.gray(Filmic.WHITE)).isEqualTo(1);
        assertThat(Filmic.gray(1e30)).isEqualTo(1);
    }

    @Property
    void gray_rises(@ForAll @FloatRange(max = 20) float a, @ForAll @FloatRange(max = 20) float b) {
        assertThat(Filmic.gray(Math.min(a, b))).isLessThanOrEqualTo(Filmic.gray(Math.max(a, b)));
    }

    /** Any bits: shown within the display, 16 bits agree with 8, and a tile with single pixels. */
    @Property
    void anyColor_isShown(@ForAll float r, @ForAll float g, @ForAll float b) {
        int[] codes = VIEW.displayed(r, g, b);
        short[] wide = new short[3];
        VIEW.pack16(r, g, b, wide, 0);
        for (int c = 0; c < 3; c++) {
            assertThat((wide[c] & 0xFFFF) / 257.0).isCloseTo(codes[c], within(0.51));
        }
        int[] pixels = new int[1];
        VIEW.packTile(new float[] {r}, new float[] {g}, new float[] {b}, 0, 0, 1, pixels);
        assertThat(pixels[0]).isEqualTo(VIEW.pack(r, g, b));
    }

    /** Below 6 stops each channel is shown as a gray of its value; at 15 stops, whatever the color, all are white. */
    @Property
    void brightColor_turnsWhite(@ForAll @FloatRange(max = 8.8f) float r, @ForAll @FloatRange(max = 8.8f) float g) {
        assertThat(VIEW.displayed(r, g, 0)).containsExactly(VIEW.encode(r), VIEW.encode(g), 0);
        assertThat(VIEW.displayed(0.18f * 0x1p15f, g, 0)).containsExactly(255, 255, 255);
    }
}
