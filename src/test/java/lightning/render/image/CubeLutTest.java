package lightning.render.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import lightning.format.image.CubeLutReader;
import lightning.sample.TryFolder;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CubeLutTest {
    /** Two points per edge: each corner of the cube keeps its color, except that black becomes gray. */
    private static final String LIFTED = """
            # a look
            TITLE "lifted"
            LUT_3D_SIZE 2
            0.5 0.5 0.5
            1 0 0
            0 1 0
            1 1 0
            0 0 1
            1 0 1
            0 1 1
            1 1 1
            """;

    @TempDir
    Path folder;

    private CubeLut table(String text) throws IOException {
        return CubeLutReader.read(Files.writeString(folder.resolve("look.cube"), text));
    }

    private static double[] of(CubeLut table, double r, double g, double b) {
        double[] color = {r, g, b};
        table.apply(color);
        return color;
    }

    @Test
    void lattice_storesRedFastest() throws IOException {
        CubeLut table = table(LIFTED);
        assertThat(of(table, 1, 0, 0)).containsExactly(1, 0, 0);
        assertThat(of(table, 0, 0, 1)).containsExactly(0, 0, 1);
        assertThat(of(table, 0, 0, 0)).containsExactly(0.5, 0.5, 0.5);
        assertThat(table.sizeText()).isEqualTo("2 × 2 × 2");
    }

    /** On the gray diagonal only black and white count; the midpoint is the mean of both. */
    @Test
    void gray_dependsOnlyOnGrayDiagonal() throws IOException {
        assertThat(of(table(LIFTED), 0.5, 0.5, 0.5)).containsExactly(0.75, 0.75, 0.75);
    }

    /** In the tetrahedron of black, red, yellow, white: 0.3 black, 0.2 red, 0.4 yellow, 0.1 white. */
    @Test
    void pointInCell_usesFourCorners() throws IOException {
        double[] color = of(table(LIFTED), 0.7, 0.5, 0.1);
        assertThat(color[0]).isCloseTo(0.3 * 0.5 + 0.2 + 0.4 + 0.1, within(1e-12));
        assertThat(color[1]).isCloseTo(0.3 * 0.5 + 0.4 + 0.1, within(1e-12));
        assertThat(color[2]).isCloseTo(0.3 * 0.5 + 0.1, within(1e-12));
    }

    @Test
    void channelTable_interpolatesLinearly() throws IOException {
        CubeLut table = table("LUT_1D_SIZE 3\n0 1 0\n0.5 0.5 0.1\n1 0 1\n");
        double[] color = of(table, 0.25, 0.25, 0.75);
        assertThat(color[0]).isCloseTo(0.25, within(1e-7));
        assertThat(color[1]).isCloseTo(0.75, within(1e-7));
        assertThat(color[2]).isCloseTo(0.55, within(1e-7));
    }

    @Test
    void domain_isScaledAndClamped() throws IOException {
        CubeLut table = table("DOMAIN_MIN -1 0 0\nDOMAIN_MAX 3 4 8\nLUT_1D_SIZE 2\n0 0 0\n1 1 1\n");
        assertThat(of(table, 1, 1, 1)).containsExactly(0.5, 0.25, 0.125);
        assertThat(of(table, -9, 99, Double.NaN)).containsExactly(0, 1, 0);
        assertThat(of(table("LUT_3D_SIZE 2\nLUT_3D_INPUT_RANGE 0 2\n" + LIFTED.substring(LIFTED.indexOf("0.5"))), 2, 2, 2))
                .containsExactly(1, 1, 1);
    }

    /** Tetrahedral interpolation reproduces affine functions of the color exactly. */
    @Property
    void latticeOfAffineFunction_isExact(@ForAll @IntRange(min = 2, max = 9) int size, @ForAll long seed,
            @ForAll @DoubleRange(min = 0, max = 1) double r, @ForAll @DoubleRange(min = 0, max = 1) double g,
            @ForAll @DoubleRange(min = 0, max = 1) double b) {
        var random = new Random(seed);
        double[][] matrix = new double[3][];
        for (int c = 0; c < 3; c++) {
            matrix[c] = random.doubles(4, -1, 1).toArray();
        }
        float[] colors = new float[3 * size * size * size];
        for (int i = 0; i < colors.length / 3; i++) {
            double[] at =
                    {(double) (i % size) / (size - 1), (double) (i / size % size) / (size - 1), (double) (i / size / size) / (size - 1)};
            for (int c = 0; c < 3; c++) {
                colors[3 * i + c] = (float) affine(matrix[c], at[0], at[1], at[2]);
            }
        }
        double[] found = of(new CubeLut(Path.of("any"), true, size, colors, new float[3], new float[] {1, 1, 1}), r, g, b);
        for (int c = 0; c < 3; c++) {
            assertThat(found[c]).isCloseTo(affine(matrix[c], r, g, b), within(1e-6));
        }
    }

    private static double affine(double[] row, double r, double g, double b) {
        return row[0] * r + row[1] * g + row[2] * b + row[3];
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "LUT_3D_SIZE 2;0 0 0 | line 2: expected 8 lines of three numbers, found 1 before the end",
        "LUT_1D_SIZE 2;0 0 0;1 1 1;2 2 2 | line 4: expected 2 lines of three numbers, found one more",
        "LUT_1D_SIZE 2;0 0;1 1 1 | line 2: expected three numbers from -10⁹ to 10⁹, found '0 0'",
        "LUT_1D_SIZE 2;0 0 nan | line 2: expected three numbers from -10⁹ to 10⁹, found '0 0 nan'",
        "LUT_1D_SIZE 2;0 0 1e10 | line 2: expected three numbers from -10⁹ to 10⁹, found '0 0 1e10'",
        "LUT_1D_SIZE 1 | line 1: expected a whole number from 2 to 65536 after LUT_1D_SIZE, found '1'",
        "LUT_3D_SIZE 130 | line 1: expected a whole number from 2 to 129 after LUT_3D_SIZE, found '130'",
        "LUT_3D_SIZE 2.5 | line 1: expected a whole number from 2 to 129 after LUT_3D_SIZE, found '2.5'",
        "LUT_1D_SIZE 2;LUT_1D_SIZE 2 | line 2: expected one size of a table in a file, found LUT_1D_SIZE again",
        "0 0 0 | line 1: expected LUT_1D_SIZE or LUT_3D_SIZE before the numbers, found '0 0 0'",
        "# nothing | line 1: expected LUT_1D_SIZE or LUT_3D_SIZE, found the end of the file",
        "JPEG | line 1: expected LUT_1D_SIZE or LUT_3D_SIZE, found the end of the file",
        "LUT_1D_SIZE 2;0 0 0;JPEG | line 3: expected three numbers or one of TITLE, LUT_1D_SIZE",
        "DOMAIN_MIN 0 1 | line 1: expected three numbers from -10⁹ to 10⁹ after DOMAIN_MIN, found 'DOMAIN_MIN 0 1'",
        "LUT_1D_SIZE 2;0 0 0;DOMAIN_MAX 2 2 2 | line 3: expected DOMAIN_MAX before the table, found it after 1 lines",
        "DOMAIN_MAX 1 0 1;LUT_1D_SIZE 2;0 0 0;1 1 1 | expected DOMAIN_MIN below DOMAIN_MAX in each channel, found 0.0 and 0.0"})
    void problems_reportLineExpectedAndFound(String text, String problem) {
        assertThatThrownBy(() -> table(text.replace(';', '\n'))).isInstanceOf(IOException.class).hasMessageContaining("look.cube, ")
                .hasMessageContaining(problem);
    }

    @Test
    void linesForOtherPrograms_areNoted() throws IOException {
        List<String> notes = new ArrayList<>();
        Path file = Files.writeString(folder.resolve("camera.cube"), "LUT_1D_SIZE 2\nLUT_IN_VIDEO_RANGE\nFOO BAR\n1 1 1\n0 0 0\n");
        assertThat(of(CubeLutReader.read(file, notes::add), 0.25, 0.5, 1)).containsExactly(new double[] {0.75, 0.5, 0}, within(1e-7));
        assertThat(notes).containsExactly("camera.cube, line 2: 'LUT_IN_VIDEO_RANGE' is not used",
                "camera.cube, line 3: 'FOO BAR' is not used");
    }

    /** Curves of 0 to 2 that invert, then a lattice that inverts again; after a byte order mark. */
    @Test
    void curvesBeforeALattice_areBothApplied() throws IOException {
        String text = "\uFEFFLUT_1D_SIZE 2\nLUT_1D_INPUT_RANGE 0 2\nLUT_3D_SIZE 2\nLUT_3D_INPUT_RANGE 0 1\n1 1 1\n0 0 0\n"
                + "1 1 1\n0 1 1\n1 0 1\n0 0 1\n1 1 0\n0 1 0\n1 0 0\n0 0 0\n";
        assertThat(of(table(text), 0.5, 1, 2)).containsExactly(new double[] {0.25, 0.5, 1}, within(1e-7));
        assertThat(table(text).sizeText()).isEqualTo("3 × 2, 2 × 2 × 2");
    }

    @Test
    void oversizedFile_isRejected() throws IOException {
        Path file = folder.resolve("large.cube");
        try (var out = new java.io.RandomAccessFile(file.toFile(), "rw")) {
            out.setLength(CubeLutReader.MAX_BYTES + 1L);
        }
        assertThatThrownBy(() -> CubeLutReader.read(file)).hasMessageContaining("expected at most 67108864 bytes, found 67108865");
        assertThatThrownBy(() -> CubeLutReader.read(folder)).hasMessageContaining("is a folder, expected a .cube LUT");
    }

    @Property
    void anyBytes_areReadOrRejectedWithMessage(@ForAll byte[] bytes) throws IOException {
        try (TryFolder files = new TryFolder()) {
            CubeLutReader.read(Files.write(files.file("any.cube"), bytes));
        } catch (IOException e) {
            assertThat(e.getMessage()).contains("expected").contains("found");
        }
    }

    private static Film gray(float v) {
        return RandomFilms.gray(2, 1, v);
    }

    /** The identity preserves the codes of each curve; over the linear curve its domain may exceed 1. */
    @Test
    void identityLut_equalsCurve() throws IOException {
        CubeLut identity = table("LUT_1D_SIZE 2\n0 0 0\n1 1 1\n");
        for (DisplayCurve curve : DisplayCurve.values()) {
            ViewTransform plain = new ViewTransform(0.5, curve);
            ViewTransform view = plain.withLut(Optional.of(identity));
            Film film = RandomFilms.anyCodes(64, 40, 1);
            int[] codes = view.toPixels(film);
            int[] expected = plain.toPixels(film);
            for (int i = 0; i < codes.length; i++) {
                for (int shift = 0; shift < 24; shift += 8) {
                    // For a value on a border between codes, the curve's table may choose the other side.
                    assertThat(Math.abs((codes[i] >> shift & 0xFF) - (expected[i] >> shift & 0xFF))).as("%s, pixel %s", curve, i)
                            .isLessThanOrEqualTo(1);
                }
            }
        }
        CubeLut halved = table("DOMAIN_MAX 2 2 2\nLUT_1D_SIZE 2\n0 0 0\n1 1 1\n");
        assertThat(new ViewTransform(0, DisplayCurve.LINEAR).withLut(Optional.of(halved)).toPixels(gray(1.6f))[0]).isEqualTo(0xFFCCCCCC);
    }

    @Test
    void lut_isAppliedAfterCurve() throws IOException {
        CubeLut inverse = table("LUT_1D_SIZE 2\n1 1 1\n0 0 0\n");
        ViewTransform view = ViewTransform.DEFAULT.withLut(Optional.of(inverse));
        assertThat(view.toPixels(gray(0.5f))[0]).isEqualTo(0xFF434343);
        short[] deep = new short[3];
        view.pack16(0.5f, 0, 1, deep, 0);
        // sRGB of 0.5 is 0.735357.
        assertThat(deep[0] & 0xFFFF).isEqualTo((int) Math.floor(65535 * (1 - 0.7353569831) + 0.5));
        assertThat(new int[] {deep[1] & 0xFFFF, deep[2]}).containsExactly(65535, 0);
        assertThat(view.description()).isEqualTo("sRGB, look.cube");
    }

    @Test
    void curveTable_isWithinOneMillionth() {
        for (int bits = 0x30000000; bits < 0x42000000; bits += 0x777) {
            float v = Float.intBitsToFloat(bits);
            assertThat(DisplayCurve.SRGB.value(v)).isCloseTo(v > 1 ? 1 : v <= 0.0031308 ? 12.92 * v : 1.055 * Math.pow(v, 1 / 2.4) - 0.055,
                    within(1e-6));
        }
        assertThat(DisplayCurve.SRGB.value(Float.NaN)).isZero();
        assertThat(DisplayCurve.ACES.value(Float.POSITIVE_INFINITY)).isEqualTo(1);
    }

    @Test
    void marks_areOnlyOnClippedPixels() {
        ViewTransform view = ViewTransform.DEFAULT.withMarksClipping(true);
        assertThat(view.pack(1, 0.5f, 0)).isEqualTo(ViewTransform.DEFAULT.pack(1, 0.5f, 0));
        assertThat(view.pack(Math.nextUp(1f), 0.5f, 0)).isEqualTo(0xFF000000 | ViewTransform.CLIPPED_MARK);
        assertThat(view.pack(0, 0, 0)).isEqualTo(0xFF000000 | ViewTransform.BLACK_MARK);
        assertThat(view.pack(0, 0.01f, 0)).isEqualTo(ViewTransform.DEFAULT.pack(0, 0.01f, 0));
        assertThat(view.withExposure(-1).pack(2, 2, 2)).isEqualTo(0xFFFFFFFF);
        assertThat(view.withCurve(DisplayCurve.FILMIC).pack(5.5f, 1, 1)).isNotEqualTo(0xFF000000 | ViewTransform.CLIPPED_MARK);
        assertThat(view.forOutput()).isEqualTo(ViewTransform.DEFAULT);
    }
}
