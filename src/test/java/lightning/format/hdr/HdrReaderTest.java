package lightning.format.hdr;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import lightning.format.mesh.MeshException;
import lightning.scene.Limits;
import lightning.scene.Sky;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Pictures byte by byte, and pictures that lie. */
class HdrReaderTest {
    private static final String HEADER = "#?RADIANCE\n# by hand\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
    /** 1, 2, 4 and black. */
    private static final byte[] TWO = {(byte) 128, 64, 32, (byte) 129, 9, 9, 9, 0};

    @TempDir
    private Path folder;

    private static byte[] file(String header, byte[] pixels) {
        var out = new ByteArrayOutputStream();
        out.writeBytes(header.getBytes(StandardCharsets.ISO_8859_1));
        out.writeBytes(pixels);
        return out.toByteArray();
    }

    private Sky read(String header, byte[] pixels) throws Exception {
        return HdrReader.read(Files.write(folder.resolve("x.hdr"), file(header, pixels)));
    }

    @Test
    void plainPixels_areMantissasTimesTwoToTheSharedExponent() throws Exception {
        Sky sky = read(HEADER, TWO);
        assertThat(new float[] {sky.channel(0, 0, 0), sky.channel(0, 0, 1), sky.channel(0, 0, 2)}).containsExactly(1, 0.5f, 0.25f);
        assertThat(sky.channel(1, 0, 0)).isZero();
    }

    @Test
    void exposure_isTakenOut() throws Exception {
        assertThat(read(HEADER.replace("# by hand", "EXPOSURE=2\nEXPOSURE= 0.25"), TWO).channel(0, 0, 0)).isEqualTo(2);
    }

    @Test
    void runs_areFilled() throws Exception {
        byte[] runs = {2, 2, 0, 9, (byte) (128 + 9), (byte) 128, (byte) (128 + 8), 64, 1, 32, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0,
            (byte) (128 + 9), (byte) 129};
        Sky sky = read(HEADER.replace("+X 2", "+X 9"), runs);
        assertThat(sky.channel(8, 0, 0)).isEqualTo(1);
        assertThat(sky.channel(7, 0, 1)).isEqualTo(0.5f);
        assertThat(sky.channel(8, 0, 1)).isEqualTo(0.25f);
        assertThat(sky.channel(3, 0, 2)).isZero();
    }

    @Test
    void brightestPixel_isHeldToTheLimit() throws Exception {
        assertThat(read(HEADER, new byte[] {-1, -1, -1, -1, 0, 0, 0, 0}).channel(0, 0, 0)).isEqualTo((float) Limits.MAX_EMISSION);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "#?RADIANCE | #?RADIANTE | line 1: a Radiance picture must begin with #?RADIANCE or #?RGBE, was '#?RADIANTE'",
        "rgbe | xyze | line 3: the format must be 32-bit_rle_rgbe, was '32-bit_rle_xyze'",
        "FORMAT= | FOR= | line 4: expected a line FORMAT=32-bit_rle_rgbe in the header, found none",
        "-Y 1 +X 2 | +X 2 -Y 1 | line 5: the size must be written as -Y HEIGHT +X WIDTH, was '+X 2 -Y 1'",
        "-Y 1 +X 2 | -Y 0 +X 2 | line 5: a picture must have from 1 to 8388608 pixels, has 2×0",
        "-Y 1 +X 2 | -Y 99999 +X 99999 | line 5: a picture must have from 1 to 8388608 pixels, has 99999×99999",
        "-Y 1 +X 2 | -Y 2000000000 +X 2000000000 | line 5: a picture must have from 1 to 8388608 pixels, has 2000000000×2000000000",
        "-Y 1 +X 2 | -Y 2048 +X 4096 | line 5: 4096×2048 pixels take at least 548864 bytes, found 8",
        "-Y 1 +X 2 | -Y 1 +X 1 | expected nothing behind the last of 1 lines, found 4 bytes",
        "# by hand | EXPOSURE=0 | line 2: an exposure must be a number from 1e-30 to 1e30, was '0'",
        "# by hand | EXPOSURE=nan | line 2: an exposure must be a number above 0, was 'nan'"})
    void lies_areToldWithTheirPlace(String right, String wrong, String message) {
        assertThatThrownBy(() -> read(HEADER.replace(right, wrong), TWO)).isInstanceOf(MeshException.class).hasMessageEndingWith(message);
    }

    @Test
    void runBeyondALine_isRefused() {
        byte[] runs = new byte[40];
        Arrays.fill(runs, (byte) 2);
        runs[2] = 0;
        runs[3] = 9;
        runs[4] = (byte) (128 + 10);
        assertThatThrownBy(() -> read(HEADER.replace("+X 2", "+X 9"), runs))
                .hasMessageEndingWith("row 1: a run must have from 1 to 9 pixels, has 10");
    }

    @Test
    void skyOfTheTextures_isThatOfTheMaker() {
        assertThat(Path.of("textures/evening_sky.hdr")).hasBinaryContent(SkyMaker.evening());
    }

    @Test
    void oldRuns_areRefused() {
        assertThatThrownBy(() -> read(HEADER, new byte[] {9, 9, 9, 9, 1, 1, 1, 1}))
                .hasMessageEndingWith("row 1: runs of pixels that are the same are not read");
    }

    /** Whatever is written over a picture, it is read, finite and not negative, or refused in a sentence. */
    @Property
    void damage_isReadOrTold(@ForAll @IntRange(max = 100) int at, @ForAll @IntRange(max = 255) int there,
            @ForAll @IntRange(max = 9) int cut)
            throws Exception {
        byte[] runs =
                {2, 2, 0, 9, (byte) (128 + 9), 3, (byte) (128 + 8), 64, 1, 32, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, (byte) (128 + 9), (byte) 129};
        byte[] bytes = file(HEADER.replace("+X 2", "+X 9"), runs);
        bytes[at % bytes.length] = (byte) there;
        Path file = Files.createTempFile("damaged", ".hdr");
        try {
            Sky sky = HdrReader.read(Files.write(file, Arrays.copyOf(bytes, bytes.length - cut)));
            for (int i = 0; i < 3 * sky.width() * sky.height(); i++) {
                assertThat(sky.channel(i / 3 % sky.width(), i / 3 / sky.width(), i % 3)).isBetween(0f, (float) Limits.MAX_EMISSION);
            }
        } catch (MeshException e) {
            assertThat(e.getMessage()).doesNotContain("\n").contains(":");
        } finally {
            Files.delete(file);
        }
    }
}
