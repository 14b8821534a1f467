package lightning.render.image.aces;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import lightning.base.math.Primaries;
import lightning.render.image.DisplayCurve;
import lightning.render.image.ViewTransform;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;

class Aces2Test {
    private static final ViewTransform VIEW = ViewTransform.DEFAULT.withCurve(DisplayCurve.ACES2);
    /** One step of an 8-bit display. */
    private static final double STEP = 1 / 255.0;

    /** Scene colors and what OpenColorIO shows: its own implementation in floats, clamped. */
    private record Sample(double[] linear, double[] shown) {
        static Sample of(String line) {
            String[] sides = line.split("\\|");
            return new Sample(numbers(sides[0]), numbers(sides[1]));
        }

        private static double[] numbers(String text) {
            return Stream.of(text.strip().split(" ")).mapToDouble(Double::parseDouble).toArray();
        }
    }

    private static List<Sample> openColorIo() throws IOException {
        try (InputStream in = Aces2Test.class.getResourceAsStream("opencolorio.txt")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().filter(line -> !line.startsWith("#")).map(Sample::of)
                    .toList();
        }
    }

    @Test
    void formulas_matchOpenColorIo() throws IOException {
        for (Sample sample : openColorIo()) {
            double[] ours = Aces2.encoded(sample.linear[0], sample.linear[1], sample.linear[2]);
            for (int c = 0; c < 3; c++) {
                // OpenColorIO interpolates cusps between other hues, and its floats round 0.1 steps away.
                assertThat(Math.clamp(ours[c], 0, 1)).as("channel %d of %s", c, Arrays.toString(sample.linear))
                        .isCloseTo(sample.shown[c], within(0.25 * STEP));
            }
        }
    }

    @Test
    void table_matchesOpenColorIo() throws IOException {
        double sum = 0;
        List<Sample> samples = openColorIo();
        for (Sample sample : samples) {
            double[] ours = Aces2Table.encoded((float) sample.linear[0], (float) sample.linear[1], (float) sample.linear[2]);
            for (int c = 0; c < 3; c++) {
                double error = Math.abs(ours[c] - sample.shown[c]);
                sum += error;
                assertThat(error).as("channel %d of %s", c, Arrays.toString(sample.linear)).isLessThan(2 * STEP);
            }
        }
        assertThat(sum / (3 * samples.size())).isLessThan(0.1 * STEP);
    }

    /** Luminances of the Academy's table for a peak of 100 nits. */
    @Test
    void tonescale_matchesAcademy() {
        assertThat(Tonescale.display(0)).isEqualTo(0);
        assertThat(100 * Tonescale.display(0.18)).isCloseTo(10.000, within(0.0006));
        assertThat(100 * Tonescale.display(1)).isCloseTo(45.757, within(0.0006));
        assertThat(100 * Tonescale.display(2)).isCloseTo(63.988, within(0.0006));
        assertThat(Tonescale.display(128)).isCloseTo(1, within(1e-12));
    }

    /** S-2014-004 gives the matrix from AP0 to AP1, and BT.709 with Bradford gives the well-known one from sRGB to ACEScg. */
    @Test
    void matrices_matchPublications() {
        assertThat(Primaries.AP0.to(Primaries.AP1).m()).containsExactly(new double[] {1.4514393161, -0.2365107469, -0.2149285693,
            -0.0765537734, 1.1762296998, -0.0996759264, 0.0083161484, -0.0060324498, 0.9977163014}, within(1e-9));
        assertThat(Primaries.REC709.to(Primaries.AP1).m()).containsExactly(new double[] {0.613097, 0.339523, 0.047379,
            0.070194, 0.916354, 0.013452, 0.020616, 0.109570, 0.869815}, within(1e-6));
    }

    @Property
    void appearanceModel_isInverted(@ForAll @DoubleRange(max = 1) double r, @ForAll @DoubleRange(max = 1) double g,
            @ForAll @DoubleRange(max = 1) double b) {
        AppearanceModel model = new AppearanceModel(Primaries.REC709);
        double[] jmh = model.jmh(r, g, b);
        assertThat(model.rgb(jmh[0], jmh[1], jmh[2])).containsExactly(new double[] {r, g, b}, within(1e-9));
    }

    @Property
    void gray_staysGray(@ForAll @DoubleRange(max = 2000) double v) {
        double[] exact = Aces2.encoded(v, v, v);
        assertThat(exact).containsOnly(new double[] {Aces2.encode(Tonescale.display(Math.min(v, Aces2.MAX)))}, within(1e-3 * STEP));
        double[] table = Aces2Table.encoded((float) v, (float) v, (float) v);
        assertThat(table).containsOnly(new double[] {Aces2Table.gray(v)}, within(0.5 * STEP));
    }

    /** Interpolation is least close where strong colors reach the display's limits. */
    @Property
    void table_isCloseToFormulas(@ForAll @DoubleRange(min = -12, max = 11) double r, @ForAll @DoubleRange(min = -12, max = 11) double g,
            @ForAll @DoubleRange(min = -12, max = 11) double b) {
        float[] color = {(float) Math.pow(2, r), (float) Math.pow(2, g), (float) Math.pow(2, b)};
        double[] exact = Aces2.encoded(color[0], color[1], color[2]);
        double[] table = Aces2Table.encoded(color[0], color[1], color[2]);
        for (int c = 0; c < 3; c++) {
            assertThat(table[c]).isCloseTo(Math.clamp(exact[c], 0, 1), within(6 * STEP));
        }
    }

    /** Any bits, with negative values, NaN and infinity: shown within the display, and 16 bits agree with 8. */
    @Property
    void anyColor_isShown(@ForAll float r, @ForAll float g, @ForAll float b) {
        int rgb = VIEW.pack(r, g, b);
        short[] wide = new short[3];
        VIEW.pack16(r, g, b, wide, 0);
        for (int c = 0; c < 3; c++) {
            assertThat((wide[c] & 0xFFFF) / 257.0).isCloseTo(rgb >> 16 - 8 * c & 0xFF, within(0.51));
        }
    }

    @Test
    void infinityAndNan_areWhiteAndBlack() {
        float infinity = Float.POSITIVE_INFINITY;
        assertThat(VIEW.pack(infinity, infinity, infinity)).isEqualTo(0xFFFFFFFF);
        assertThat(VIEW.pack(Float.NaN, Float.NaN, Float.NaN)).isEqualTo(0xFF000000);
        assertThat(VIEW.pack(Float.NEGATIVE_INFINITY, -1, -0f)).isEqualTo(0xFF000000);
        assertThat(VIEW.pack(-1, infinity, 0)).isEqualTo(VIEW.pack(-1, Float.MAX_VALUE, 0));
    }

    @Test
    void description_namesCurve() {
        assertThat(VIEW.description()).isEqualTo("ACES 2");
        assertThat(VIEW.forOutput()).isEqualTo(VIEW);
    }
}
