package lightning.render.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.IntRange;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class ViewTransformTest {

    @Test
    void knownCodes_matchStandard() {
        assertThat(ViewTransform.DEFAULT.encode(0)).isEqualTo(0);
        assertThat(ViewTransform.DEFAULT.encode(1)).isEqualTo(255);
        // 1.055 · 0.5^(1/2.4) − 0.055 = 0.735357, and · 255 slightly above 187.5: 187.516
        assertThat(ViewTransform.DEFAULT.encode(0.5f)).isEqualTo(188);
        // The gray card: 1.055 · 0.18^(1/2.4) − 0.055 = 0.461356, · 255 = 117.65
        assertThat(ViewTransform.DEFAULT.encode(0.18f)).isEqualTo(118);
        // The straight part: 12.92 · 0.002 · 255 = 6.589
        assertThat(ViewTransform.DEFAULT.encode(0.002f)).isEqualTo(7);
    }

    @Test
    void curveOf1998_isLinear() {
        ViewTransform view = ViewTransform.DEFAULT.withCurve(DisplayCurve.LINEAR);
        assertThat(view.encode(0)).isEqualTo(0);
        assertThat(view.encode(1)).isEqualTo(255);
        // 0.18 · 255 = 45.9
        assertThat(view.encode(0.18f)).isEqualTo(46);
        for (int code = 0; code < 256; code++) {
            assertThat(view.encode(code / 255f)).isEqualTo(code);
        }
        assertThat(view.withExposure(1).encode(0.25f)).isEqualTo(view.encode(0.5f));
    }

    @ParameterizedTest
    @EnumSource
    void outOfRangeValues_areClampedByEveryCurve(DisplayCurve curve) {
        ViewTransform view = ViewTransform.DEFAULT.withCurve(curve);
        assertThat(List.of(view.encode(-1), view.encode(-0f), view.encode(Float.NaN), view.encode(Float.NEGATIVE_INFINITY)))
                .containsOnly(0);
        assertThat(List.of(view.encode(128), view.encode(Float.MAX_VALUE), view.encode(Float.POSITIVE_INFINITY))).containsOnly(255);
    }

    @ParameterizedTest
    @EnumSource
    void everyCurveTable_matchesFormula(DisplayCurve curve) {
        for (int bits = 0x38000000; bits < 0x42000000; bits += 0x777) {
            float v = Float.intBitsToFloat(bits);
            if (curve.table().encode(v) != curve.formula(v)) {
                assertThat(curve.table().encode(v)).as("code of %s", v).isEqualTo(curve.formula(v));
            }
        }
    }

    /** Computed by hand from the published formulas. */
    @Test
    void toneCurves_matchPublications() {
        // Narkowicz at 1: 2.54 / 3.16.
        assertThat(ToneCurves.aces(1)).isCloseTo(2.54 / 3.16, Offset.offset(1e-12));
        assertThat(ToneCurves.aces(0)).isZero();
        assertThat(ToneCurves.aces(Math.nextDown(ToneCurves.ACES_WHITE))).isCloseTo(1, Offset.offset(1e-12));
    }

    @Test
    void falseColor_isGrayAroundMiddleGray() {
        ViewTransform stops = ViewTransform.DEFAULT.withCurve(DisplayCurve.FALSE);
        int gray = stops.pack(0.18f, 0.18f, 0.18f);
        assertThat(gray).isEqualTo(0xFF808080);
        assertThat(List.of(stops.pack(0.13f, 0.13f, 0.13f), stops.pack(0.25f, 0.25f, 0.25f))).containsOnly(gray);
        assertThat(stops.pack(0.126f, 0.126f, 0.126f)).isNotEqualTo(gray);
        assertThat(stops.pack(0.256f, 0.256f, 0.256f)).isNotEqualTo(gray);
        List<FalseColor.Band> bands = FalseColor.bands();
        for (FalseColor.Band band : bands) {
            float v = (float) (FalseColor.MIDDLE_GRAY * Math.scalb(1.0, band.stop()));
            assertThat(stops.pack(v, v, v)).isEqualTo(0xFF000000 | band.rgb());
        }
        assertThat(List.of(stops.pack(0, 0, 0), stops.pack(Float.NaN, 0, 0))).containsOnly(0xFF000000 | bands.getFirst().rgb());
        assertThat(stops.pack(Float.POSITIVE_INFINITY, 0, 0)).isEqualTo(0xFF000000 | bands.getLast().rgb());
        assertThat(bands).extracting(FalseColor.Band::rgb).doesNotHaveDuplicates();
    }

    @Test
    void falseColor_isNotSaved() {
        ViewTransform stops = new ViewTransform(0.5, DisplayCurve.FALSE);
        assertThat(stops.forOutput()).isEqualTo(new ViewTransform(0.5));
        assertThat(new ViewTransform(-0.5, DisplayCurve.ACES).description()).isEqualTo("ACES (Approximation), -0.5 stops");
    }

    @Test
    void outOfRangeValues_areClamped() {
        assertThat(ViewTransform.DEFAULT.encode(-1)).isEqualTo(0);
        assertThat(ViewTransform.DEFAULT.encode(-0f)).isEqualTo(0);
        assertThat(ViewTransform.DEFAULT.encode(Float.NaN)).isEqualTo(0);
        assertThat(ViewTransform.DEFAULT.encode(-Float.NaN)).isEqualTo(0);
        assertThat(ViewTransform.DEFAULT.encode(Float.NEGATIVE_INFINITY)).isEqualTo(0);
        assertThat(ViewTransform.DEFAULT.encode(1.5f)).isEqualTo(255);
        assertThat(ViewTransform.DEFAULT.encode(Float.POSITIVE_INFINITY)).isEqualTo(255);
    }

    @Test
    void table_matchesFormulaAroundThresholds() {
        for (int code = 1; code < 256; code++) {
            float threshold = Srgb.THRESHOLD[code];
            assertThat(Srgb.formula(Math.nextDown(threshold))).isEqualTo(code - 1);
            assertThat(Srgb.formula(threshold)).isEqualTo(code);
            for (int step = -3; step <= 3; step++) {
                float v = Float.intBitsToFloat(Float.floatToRawIntBits(threshold) + step);
                assertThat(Srgb.encode(v)).isEqualTo(Srgb.formula(v));
            }
        }
    }

    @Test
    void table_matchesFormulaAtBucketBorders() {
        for (int bits = 0x38000000; bits < 0x40000000; bits += 0x333) {
            float v = Float.intBitsToFloat(bits);
            if (Srgb.encode(v) != Srgb.formula(v)) {
                assertThat(Srgb.encode(v)).as("code of %s", v).isEqualTo(Srgb.formula(v));
            }
        }
    }

    @Property(tries = 20_000)
    void table_matchesFormulaForAnyBits(@ForAll int bits) {
        float v = Float.intBitsToFloat(bits);

        assertThat(Srgb.encode(v)).isEqualTo(Srgb.formula(v));
    }

    @Test
    void everyCode_roundTrips() {
        for (int code = 0; code < 256; code++) {
            assertThat(ViewTransform.DEFAULT.encode(ViewTransform.linear(code))).isEqualTo(code);
        }
    }

    @Property
    void oneStopMore_doublesLight(@ForAll float linear, @ForAll @IntRange(min = -60, max = 60) int stops) {
        assertThat(new ViewTransform(stops + 1).gain()).isEqualTo(2 * new ViewTransform(stops).gain());
        assertThat(new ViewTransform(1).encode(linear)).isEqualTo(ViewTransform.DEFAULT.encode(2 * linear));
    }

    @Property
    void packedPixels_areOpaqueScanlines(@ForAll("films") Film film) {
        ViewTransform view = new ViewTransform(0.5);
        int[] pixels = view.toPixels(film);
        for (int y = 0; y < film.height(); y++) {
            for (int x = 0; x < film.width(); x++) {
                int expected = 0xFF000000 | view.encode(film.red(x, y)) << 16 | view.encode(film.green(x, y)) << 8
                        | view.encode(film.blue(x, y));
                assertThat(pixels[y * film.width() + x]).isEqualTo(expected);
            }
        }
    }

    @Test
    void packTile_writesOnlyItsPixels() {
        Film film = RandomFilms.gray(40, 40, 1);
        int[] pixels = new int[40 * 40];

        ViewTransform.DEFAULT.packTile(film, 3, pixels);

        for (int i = 0; i < pixels.length; i++) {
            boolean inside = i % 40 >= 32 && i / 40 >= 32;
            assertThat(pixels[i]).isEqualTo(inside ? 0xFFFFFFFF : 0);
        }
    }

    @Test
    void invalidExposure_isRejected() {
        assertThatThrownBy(() -> new ViewTransform(Double.NaN)).hasMessageContaining("was NaN");
        assertThatThrownBy(() -> new ViewTransform(65)).hasMessageContaining("from -64 to 64");
    }

    @Provide
    Arbitrary<Film> films() {
        return RandomFilms.anyBits();
    }
}
