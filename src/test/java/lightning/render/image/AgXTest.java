package lightning.render.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.FloatRange;
import org.junit.jupiter.api.Test;

class AgXTest {
    private static final ViewTransform VIEW = ViewTransform.DEFAULT.withCurve(DisplayCurve.AGX);

    private static int[] pack(double r, double g, double b) {
        int rgb = VIEW.pack((float) r, (float) g, (float) b);
        return new int[] {rgb >> 16 & 0xFF, rgb >> 8 & 0xFF, rgb & 0xFF};
    }

    /** Sobotka's configuration puts the pivot of the curve, which middle gray meets, at 0.5 of the display. */
    @Test
    void middleGray_isHalfOfDisplay() {
        assertThat(AgX.gray(0.18)).isCloseTo(0.5, within(1e-15));
        // 0.5 · 255 = 127.5: between both codes.
        assertThat(VIEW.encode(0.18f)).isBetween(127, 128);
    }

    @Test
    void ends_areBlackAndWhite() {
        assertThat(pack(0, 0, 0)).containsExactly(0, 0, 0);
        assertThat(AgX.gray(0)).isCloseTo(0, within(1e-15));
        assertThat(AgX.gray(0.18 * Math.pow(2, -10))).isCloseTo(0, within(1e-15));
        assertThat(AgX.gray(AgX.WHITE)).isCloseTo(1, within(1e-15));
        assertThat(AgX.gray(1e30)).isCloseTo(1, within(1e-15));
        // The published ends around 1: -12.47393 and 4.026069 stops.
        assertThat(Math.log(0.18) / Math.log(2) - 10).isCloseTo(-12.47393, within(1e-5));
        assertThat(Math.log(AgX.WHITE) / Math.log(2)).isCloseTo(4.026069, within(1e-6));
    }

    /** Wrensch's and others' closed form of the same curve: 2 · (x − t) · (1 + a · |x − t|^p)^(−1/p) + 0.5. */
    @Test
    void curve_matchesPublishedCoefficients() {
        double t = 0.6060606060606061;
        for (double x = 0; x <= 1; x += 1.0 / 64) {
            double a = x < t ? 59.507875 : 69.86278913545539;
            double p = x < t ? 3 : 3.25;
            double expected = 0.5 + 2 * (x - t) * Math.pow(1 + a * Math.pow(Math.abs(x - t), p), -1 / p);
            assertThat(AgX.gray(0.18 * Math.pow(2, -10 + 16.5 * x))).isCloseTo(expected, within(1e-9));
        }
    }

    /** The first rows and columns of Sobotka's matrix, which was rounded from chromaticities, to its precision. */
    @Test
    void inset_matchesPublishedMatrix() {
        double[][] published = {{0.842479062253094, 0.0423282422610123, 0.0423756549057051},
            {0.0784335999999992, 0.878468636469772, 0.0784336}, {0.0792237451477643, 0.0791661274605434, 0.879142973793104}};
        for (int primary = 0; primary < 3; primary++) {
            double center = AgX.center(primary == 0 ? 1 : 0, primary == 1 ? 1 : 0, primary == 2 ? 1 : 0);
            for (int c = 0; c < 3; c++) {
                assertThat(AgX.inset(primary == c ? 1 : 0, center)).isCloseTo(published[primary][c], within(2e-4));
            }
        }
    }

    @Property
    void outset_undoesInset(@ForAll @DoubleRange(max = 20) double r, @ForAll @DoubleRange(max = 20) double g,
            @ForAll @DoubleRange(max = 20) double b) {
        double center = AgX.center(r, g, b);
        double ir = AgX.inset(r, center);
        double ig = AgX.inset(g, center);
        double ib = AgX.inset(b, center);
        double back = AgX.center(ir, ig, ib);
        assertThat(AgX.outset(ir, back)).isCloseTo(r, within(1e-12));
        assertThat(AgX.outset(ig, back)).isCloseTo(g, within(1e-12));
        assertThat(AgX.outset(ib, back)).isCloseTo(b, within(1e-12));
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
        assertThat(pack(Double.POSITIVE_INFINITY, 0, Double.NaN)).containsExactly(255, 255, 255);
        assertThat(pack(Double.NaN, Double.NEGATIVE_INFINITY, -1)).containsExactly(0, 0, 0);
    }

    /** The channel range of a color never grows over the last stops, and is gone where its darkest inset channel is white. */
    @Property
    void saturatedHighlight_turnsWhite(@ForAll @FloatRange(max = 1) float g, @ForAll @FloatRange(max = 1) float b) {
        int last = 255;
        for (int stops = 4; stops <= 9; stops++) {
            double gain = Math.pow(2, stops);
            int[] codes = pack(gain, g * gain, b * gain);
            int range = Math.max(codes[0], Math.max(codes[1], codes[2])) - Math.min(codes[0], Math.min(codes[1], codes[2]));
            assertThat(range).isLessThanOrEqualTo(last + 1);
            last = range;
        }
        // 2⁹ · 0.2 · 0.212 = 21.7, above 16.29.
        assertThat(pack(512, g * 512, b * 512)).containsExactly(255, 255, 255);
    }

    /** A bright red lamp: green and blue rise together, so that its hue stays red on the way to white. */
    @Test
    void brightRed_keepsItsHue() {
        for (double gain = 1; gain < 512; gain *= 1.3) {
            int[] codes = pack(gain, 0.02 * gain, 0.02 * gain);
            assertThat(codes[1]).isEqualTo(codes[2]);
            assertThat(codes[0]).isGreaterThanOrEqualTo(codes[1]);
        }
    }

    @Test
    void description_namesCurve() {
        assertThat(VIEW.description()).isEqualTo("AgX");
        assertThat(VIEW.forOutput()).isEqualTo(VIEW);
    }
}
