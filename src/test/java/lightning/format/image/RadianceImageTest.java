package lightning.format.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import lightning.base.file.UnusableFileException;
import lightning.sample.TryFolder;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureUsage;
import lightning.scene.value.SceneLimits;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Valid images byte by byte, and invalid ones. */
class RadianceImageTest {
    private static final String HEADER = "#?RADIANCE\n# by hand\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
    /** Pixels of 1, 2, 4 and black. */
    private static final byte[] TWO_PIXELS = {(byte) 128, 64, 32, (byte) 129, 9, 9, 9, 0};

    @TempDir
    private Path folder;

    private static byte[] file(String header, byte[] pixels) {
        var out = new ByteArrayOutputStream();
        out.writeBytes(header.getBytes(StandardCharsets.ISO_8859_1));
        out.writeBytes(pixels);
        return out.toByteArray();
    }

    private static Texture read(Path file) throws IOException {
        return ImageFile.readPicture(file, image -> image.texture(TextureUsage.COLOR, 1));
    }

    private Texture read(String header, byte[] pixels) throws Exception {
        return read(Files.write(folder.resolve("x.hdr"), file(header, pixels)));
    }

    @Test
    void uncompressedPixels_areDecoded() throws Exception {
        Texture environment = read(HEADER, TWO_PIXELS);
        assertThat(new float[] {environment.channel(0, 0, 0), environment.channel(0, 0, 1), environment.channel(0, 0, 2)})
                .containsExactly(1, 0.5f, 0.25f);
        assertThat(environment.channel(1, 0, 0)).isZero();
    }

    @Test
    void exposure_isDividedOut() throws Exception {
        assertThat(read(HEADER.replace("# by hand", "EXPOSURE=2\nEXPOSURE= 0.25"), TWO_PIXELS).channel(0, 0, 0)).isEqualTo(2);
    }

    @Test
    void colorCorrection_isDividedOut() throws Exception {
        Texture image = read(HEADER.replace("# by hand", "COLORCORR=2 1 4\nCOLORCORR= 1 0.5 1"), TWO_PIXELS);
        Texture plain = read(HEADER, TWO_PIXELS);
        for (int c = 0; c < 3; c++) {
            assertThat(image.channel(0, 0, c)).isEqualTo(plain.channel(0, 0, c) / new float[] {2, 0.5f, 4}[c]);
        }
    }

    /** White of sRGB, D65, has X 0.9505, Y 1 and Z 1.089; red has 0.4124, 0.2126 and 0.0193 (IEC 61966-2-1). */
    @Test
    void xyz_becomesRgb() throws Exception {
        byte[] xyz = {122, (byte) 128, (byte) 139, (byte) 129, (byte) 211, 109, 10, 127};
        Texture image = read(HEADER.replace("rgbe", "xyze"), xyz);
        for (int c = 0; c < 3; c++) {
            assertThat(image.channel(0, 0, c)).isCloseTo(1, within(0.02f));
            assertThat(image.channel(1, 0, c)).isCloseTo(c == 0 ? 1 : 0, within(0.02f)).isNotNegative();
        }
    }

    @Test
    void runs_areExpanded() throws Exception {
        byte[] runs = {2, 2, 0, 9, (byte) (128 + 9), (byte) 128, (byte) (128 + 8), 64, 1, 32, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0,
            (byte) (128 + 9), (byte) 129};
        Texture environment = read(HEADER.replace("+X 2", "+X 9"), runs);
        assertThat(environment.channel(8, 0, 0)).isEqualTo(1);
        assertThat(environment.channel(7, 0, 1)).isEqualTo(0.5f);
        assertThat(environment.channel(8, 0, 1)).isEqualTo(0.25f);
        assertThat(environment.channel(3, 0, 2)).isZero();
    }

    @Test
    void brightestPixel_isClamped() throws Exception {
        assertThat(read(HEADER, new byte[] {-1, -1, -1, -1, 0, 0, 0, 0}).channel(0, 0, 0)).isEqualTo((float) SceneLimits.MAX_EMISSION);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "#?RADIANCE | RADIANCE | line 1: a Radiance HDR image must begin with #?RADIANCE or #?RGBE, was 'RADIANCE'",
        "rgbe | luv | line 3: the format must be 32-bit_rle_rgbe or 32-bit_rle_xyze, was '32-bit_rle_luv'",
        "-Y 1 +X 2 | +X 2 -X 1 | line 5: the size must be written as -Y HEIGHT +X WIDTH, was '+X 2 -X 1'",
        "-Y 1 +X 2 | -Y 0 +X 2 | x.hdr: must have from 1 to 16384 pixels along each side, has 2×0",
        "-Y 1 +X 2 | -Y 99999 +X 99999 | x.hdr: must have from 1 to 16384 pixels along each side, has 99999×99999",
        "-Y 1 +X 2 | -Y 2000000000 +X 2000000000 | x.hdr: must have from 1 to 16384 pixels along each side, has 2000000000×2000000000",
        "-Y 1 +X 2 | -Y 2048 +X 4096 | row 1: expected more pixels, found the end of the file",
        "# by hand | EXPOSURE=0 | line 2: an exposure must be a number from 1e-30 to 1e30, was '0'",
        "# by hand | EXPOSURE=nan | line 2: an exposure must be a number above 0, was 'nan'"})
    void invalidFile_isReportedWithLocation(String valid, String invalid, String message) {
        assertThatThrownBy(() -> read(HEADER.replace(valid, invalid), TWO_PIXELS)).isInstanceOf(UnusableFileException.class)
                .hasMessageEndingWith(message);
    }

    @Test
    void runBeyondScanline_isRejected() {
        byte[] runs = new byte[40];
        Arrays.fill(runs, (byte) 2);
        runs[2] = 0;
        runs[3] = 9;
        runs[4] = (byte) (128 + 10);
        assertThatThrownBy(() -> read(HEADER.replace("+X 2", "+X 9"), runs))
                .hasMessageEndingWith("row 1: a run must have from 1 to 9 pixels, has 10");
    }

    @Test
    void texturesFolder_hasTheGeneratedEnvironments() {
        assertThat(EnvironmentMaker.NAMES).hasSize(4)
                .allSatisfy(name -> assertThat(Path.of("textures", name)).hasBinaryContent(EnvironmentMaker.map(name)));
    }

    /** A run of 2, then one of 1 · 256 pixels. */
    @Test
    void oldRuns_areExpanded() throws Exception {
        Texture environment = read(HEADER.replace("+X 2", "+X 260"),
                new byte[] {(byte) 128, 64, 32, (byte) 129, 1, 1, 1, 2, 1, 1, 1, 1, 0, (byte) 128, 0, (byte) 129});
        assertThat(environment.channel(258, 0, 0)).isEqualTo(1);
        assertThat(environment.channel(259, 0, 0)).isZero();
        assertThat(environment.channel(259, 0, 1)).isEqualTo(1);
        assertThatThrownBy(() -> read(HEADER, new byte[] {9, 9, 9, 9, 1, 1, 1, 2}))
                .hasMessageEndingWith("row 1: a run must follow a pixel and have at most 1 pixels, has 2");
    }

    /** Of two pixels, the first in the file has red 1. */
    @ParameterizedTest
    @CsvSource({"-Y 1 +X 2, 2, 0, 0", "-Y 1 -X 2, 2, 1, 0", "+Y 2 +X 1, 1, 0, 1", "+X 2 -Y 1, 2, 0, 0", "-X 2 +Y 1, 2, 1, 0",
        "+X 1 -Y 2, 1, 0, 0", "+X 1 +Y 2, 1, 0, 1"})
    void everyOrientation_isRead(String size, int width, int x, int y) throws Exception {
        Texture environment = read(HEADER.replace("-Y 1 +X 2", size), TWO_PIXELS);
        assertThat(environment.width()).isEqualTo(width);
        assertThat(environment.channel(x, y, 0)).isEqualTo(1);
    }

    @Test
    void headerWithoutFormat_andBytesAtTheEnd_areAccepted() throws Exception {
        assertThat(read(HEADER.replace("FORMAT=32-bit_rle_rgbe\n", "").replace("+X 2", "+X 1"), TWO_PIXELS).channel(0, 0, 0)).isEqualTo(1);
    }

    /** An image with any overwritten byte is read as finite, nonnegative values, or rejected with a message. */
    @Property
    void damagedFile_isReadOrReported(@ForAll @IntRange(max = 100) int index, @ForAll @IntRange(max = 255) int newByte,
            @ForAll @IntRange(max = 9) int length)
            throws Exception {
        byte[] runs =
                {2, 2, 0, 9, (byte) (128 + 9), 3, (byte) (128 + 8), 64, 1, 32, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, (byte) (128 + 9), (byte) 129};
        byte[] bytes = file(HEADER.replace("+X 2", "+X 9"), runs);
        bytes[index % bytes.length] = (byte) newByte;
        try (TryFolder files = new TryFolder()) {
            Texture environment =
                    read(Files.write(files.file("damaged.hdr"), Arrays.copyOf(bytes, bytes.length - length)));
            for (int i = 0; i < 3 * environment.width() * environment.height(); i++) {
                assertThat(environment.channel(i / 3 % environment.width(), i / 3 / environment.width(), i % 3)).isBetween(0f,
                        (float) SceneLimits.MAX_EMISSION);
            }
        } catch (UnusableFileException e) {
            assertThat(e.getMessage()).doesNotContain("\n").contains(":");
        }
    }
}
