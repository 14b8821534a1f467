package lightning.render.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.FloatRange;
import org.junit.jupiter.api.Test;

class AgXTest {
    private static final ViewTransform VIEW = ViewTransform.DEFAULT.withCurve(DisplayCurve.AGX);

    private static int[] pack(double r, double g, double b) {
        int rgb = VIEW.pack((float) r, (float) g, (float) b);
        return new int[] {rgb >> 16 & 0xFF, rgb >> 8 & 0xFF, rgb & 0xFF};
    }

    /** The curve keeps middle gray: 1.055 · 0.18^(1/2.4) − 0.055. */
    @Test
    void middleGray_isKept() {
        assertThat(AgX.gray(0.18)).isCloseTo(1.055 * Math.pow(0.18, 1 / 2.4) - 0.055, within(1e-15));
        // · 255 = 117.6
        assertThat(pack(0.18, 0.18, 0.18)).containsExactly(118, 118, 118);
    }

    @Test
    void ends_areBlackAndWhite() {
        assertThat(pack(0, 0, 0)).containsExactly(0, 0, 0);
        assertThat(AgX.gray(0)).isCloseTo(0, within(1e-15));
        assertThat(AgX.gray(0.18 * Math.pow(2, -10))).isCloseTo(0, within(1e-15));
        assertThat(AgX.gray(AgX.WHITE)).isCloseTo(1, within(1e-15));
        assertThat(AgX.gray(1e30)).isCloseTo(1, within(1e-15));
        // The published end around 1: 4.026069 stops.
        assertThat(Math.log(AgX.WHITE) / Math.log(2)).isCloseTo(4.026069, within(1e-6));
    }

    @Property
    void gray_staysGray(@ForAll float v) {
        int[] codes = pack(v, v, v);
        assertThat(codes[1]).isEqualTo(codes[0]);
        assertThat(codes[2]).isEqualTo(codes[0]);
        assertThat(codes[0]).isCloseTo(VIEW.encode(v), within(1));
        short[] wide = new short[3];
        VIEW.pack16(v, v, v, wide, 0);
        assertThat(wide[1]).isEqualTo(wide[0]);
        assertThat(wide[2]).isEqualTo(wide[0]);
        assertThat((wide[0] & 0xFFFF) / 257.0).isCloseTo(codes[0], within(0.51));
    }

    @Property
    void gray_rises(@ForAll @FloatRange(max = 20) float a, @ForAll @FloatRange(max = 20) float b) {
        assertThat(AgX.gray(Math.min(a, b))).isLessThanOrEqualTo(AgX.gray(Math.max(a, b)));
    }

    /** Any bits, with negative values, NaN and infinity: shown within the display, and 16 bits agree with 8. */
    @Property
    void anyColor_isShown(@ForAll float r, @ForAll float g, @ForAll float b) {
        int[] codes = pack(r, g, b);
        short[] wide = new short[3];
        VIEW.pack16(r, g, b, wide, 0);
        for (int c = 0; c < 3; c++) {
            assertThat((wide[c] & 0xFFFF) / 257.0).isCloseTo(codes[c], within(0.51));
        }
    }

    @Test
    void infinityAndNan_areWhiteAndBlack() {
        double infinity = Double.POSITIVE_INFINITY;
        assertThat(pack(infinity, infinity, infinity)).containsExactly(255, 255, 255);
        assertThat(pack(Double.NaN, Double.NEGATIVE_INFINITY, -1)).containsExactly(0, 0, 0);
    }

    /** The channel range of a color never grows over the last stops. */
    @Property
    void saturatedHighlight_approachesWhite(@ForAll @FloatRange(max = 1) float g, @ForAll @FloatRange(max = 1) float b) {
        int last = 255;
        for (int stops = 4; stops <= 9; stops++) {
            double gain = Math.pow(2, stops);
            int[] codes = pack(gain, g * gain, b * gain);
            int range = Math.max(codes[0], Math.max(codes[1], codes[2])) - Math.min(codes[0], Math.min(codes[1], codes[2]));
            assertThat(range).isLessThanOrEqualTo(last + 1);
            last = range;
        }
        assertThat(last).isLessThan(64);
    }

    @Test
    void description_namesCurve() {
        assertThat(VIEW.description()).isEqualTo("AgX");
        assertThat(VIEW.forOutput()).isEqualTo(VIEW);
    }
}
