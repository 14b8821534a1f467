package lightning.render.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import lightning.format.image.CubeLutReader;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class Log2ShaperTest {
    @TempDir
    Path folder;

    /** Middle gray is in the middle; the ends are the published 0.002 and 16.291. */
    @Test
    void aces48Nits_matchesPublishedEnds() {
        assertThat(Log2Shaper.DEFAULT.encode(0.18)).isCloseTo(0.5, within(1e-15));
        assertThat(Log2Shaper.DEFAULT.encode(0.18 * Math.pow(2, -6.5))).isCloseTo(0, within(1e-15));
        assertThat(Log2Shaper.DEFAULT.encode(16.29174)).isCloseTo(1, within(1e-6));
        assertThat(0.18 * Math.pow(2, -6.5)).isCloseTo(0.002, within(1e-4));
    }

    @Test
    void valuesOutside_areClamped() {
        assertThat(Log2Shaper.DEFAULT.encode(0)).isZero();
        assertThat(Log2Shaper.DEFAULT.encode(-1)).isZero();
        assertThat(Log2Shaper.DEFAULT.encode(Double.NaN)).isZero();
        assertThat(Log2Shaper.DEFAULT.encode(Double.POSITIVE_INFINITY)).isEqualTo(1);
    }

    @Property
    void oneStop_isOneEqualStep(@ForAll @DoubleRange(min = 0.01, max = 7) double v) {
        double step = Log2Shaper.DEFAULT.encode(2 * v) - Log2Shaper.DEFAULT.encode(v);
        assertThat(step).isCloseTo(1 / 13.0, within(1e-12));
    }

    @ParameterizedTest
    @CsvSource({"1, 1", "2, 1", "NaN, 1", "0, Infinity", "-65, 0", "0, 65"})
    void invalidStops_areRejected(double min, double max) {
        assertThatThrownBy(() -> new Log2Shaper(min, max))
                .hasMessageContaining("log2: expected two rising numbers of stops from -64 to 64");
    }

    /** A table that inverts its channels, after the logarithm of −10 to 6.5 stops. Middle gray becomes 1 − 10 / 16.5. */
    @Test
    void table_receivesLogarithmOfExposedLight() throws IOException {
        CubeLut inverse =
                CubeLutReader.read(Files.writeString(folder.resolve("look.cube"), "LUT_1D_SIZE 2\n1 1 1\n0 0 0\n"));
        ViewTransform view = new ViewTransform(1, DisplayCurve.FILMIC).withLut(Optional.of(inverse))
                .withShaper(Optional.of(new Log2Shaper(-10, 6.5)));
        // 255 · (1 − 0.60606) = 100.45
        assertThat(view.pack(0.09f, 0.09f, 0.09f)).isEqualTo(0xFF646464);
        assertThat(view.pack(0, 100, 0)).isEqualTo(0xFFFF00FF);
        short[] wide = new short[3];
        view.pack16(0.09f, 0.09f, 0.09f, wide, 0);
        // 65535 · 0.393939 = 25816.8
        assertThat(wide[0]).isEqualTo((short) 25817);
        assertThat(view.description()).isEqualTo("log2:-10,6.5, look.cube, +1 stops");
        assertThat(view.forOutput()).isEqualTo(view);
    }

    @Test
    void withoutTable_isIgnored() {
        ViewTransform view = ViewTransform.DEFAULT.withShaper(Optional.of(Log2Shaper.DEFAULT));
        assertThat(view.pack(0.18f, 0.5f, 1)).isEqualTo(ViewTransform.DEFAULT.pack(0.18f, 0.5f, 1));
        assertThat(view.description()).isEqualTo("sRGB");
    }

    @Test
    void commentOfFile_setsLogarithm() throws IOException {
        String table = "LUT_1D_SIZE 2\n1 1 1\n0 0 0\n";
        CubeLut plain = CubeLutReader.read(Files.writeString(folder.resolve("plain.cube"), "# any comment\n" + table));
        CubeLut log = CubeLutReader.read(Files.writeString(folder.resolve("log.cube"), "# LIGHTNING_SHAPER log2:-10,6.5\n" + table));
        assertThat(plain.log()).isEmpty();
        assertThat(log.log()).contains(new Log2Shaper(-10, 6.5));
        ViewTransform expected = ViewTransform.DEFAULT.withLut(Optional.of(plain)).withShaper(Optional.of(new Log2Shaper(-10, 6.5)));
        ViewTransform found = new ViewTransform(0, DisplayCurve.AGX).withLut(Optional.of(log));
        assertThat(found.pack(0.1f, 0.5f, 3)).isEqualTo(expected.pack(0.1f, 0.5f, 3));
        assertThat(found.description()).isEqualTo("log2:-10,6.5, log.cube");
    }

    @ParameterizedTest
    @ValueSource(strings = {"log2", "log2:1", "log2:2,1", "log2:a,b", "log3:-1,1", "x"})
    void invalidCommentOfFile_isRejected(String shaper) throws IOException {
        Path file = Files.writeString(folder.resolve("log.cube"), "# LIGHTNING_SHAPER " + shaper + "\nLUT_1D_SIZE 2\n1 1 1\n0 0 0\n");
        assertThatThrownBy(() -> CubeLutReader.read(file)).isInstanceOf(IOException.class).hasMessageContaining(
                "log.cube, line 1: expected a logarithm such as log2:-9,12 after # LIGHTNING_SHAPER, found '" + shaper + "'");
    }

    /** 0.18 · 2² = 0.72, the upper end of the logarithm; sRGB alone clips at 1. */
    @Test
    void lightAboveTheLogarithm_isClipped() {
        CubeLut table = new CubeLut(Path.of("any"), false, 2, new float[] {0, 0, 0, 1, 1, 1}, new float[3], new float[] {1, 1, 1});
        ViewTransform view = ViewTransform.DEFAULT.withLut(Optional.of(table)).withShaper(Optional.of(new Log2Shaper(-2, 2)));
        Film film = Film.ofScanlines(2, 1, new float[] {0.7f, 0, 0, 0.73f, 0, 0});
        assertThat(Clipping.of(film, view).clippedPixels()).isOne();
        assertThat(Clipping.of(film, ViewTransform.DEFAULT).clippedPixels()).isZero();
    }
}
