package lightning.format.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import lightning.base.math.SrgbCurve;
import lightning.render.image.Film;
import lightning.render.image.RandomFilms;
import lightning.render.image.ViewTransform;
import lightning.sample.Slow;
import lightning.sample.TryFolder;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Slow
class ImageFileTest {

    @TempDir
    Path folder;

    @Property(tries = 100)
    void pfm_roundTripsEveryBit(@ForAll("films") Film film) throws IOException {
        assertThat(writtenAndRead("a.pfm", film).hasSameBits(film)).isTrue();
    }

    @Property(tries = 50)
    void png_roundTripsDisplayedPixels(@ForAll("films") Film film) throws IOException {
        assertThat(displayed(writtenAndRead("a.png", film))).containsExactly(displayed(film));
    }

    @Property(tries = 50)
    void xpm_roundTripsDisplayedPixels(@ForAll("films") Film film) throws IOException {
        assertThat(writtenXpm(film)).containsExactly(rgb(film));
    }

    @Property(tries = 50)
    void floatExr_roundTripsEveryBit(@ForAll("films") Film film) throws IOException {
        try (TryFolder files = new TryFolder()) {
            Path file = files.file("a.exr");
            ImageFile.write(file, film, ViewTransform.DEFAULT, 32);
            assertThat(ImageFile.read(file).hasSameBits(film)).isTrue();
        }
    }

    @Test
    void exr_isHalfByDefault() throws IOException {
        Film film = Film.ofScanlines(1, 1, new float[] {0.1f, 1, 70_000});
        assertThat(writtenAndRead("a.exr", film).toScanlines()).containsExactly(0.099975586f, 1, 65504);
    }

    /** With 16 bits each code follows the formula, and is read as the value that it encodes. */
    @Test
    void png16_isWithinHalfACode() throws IOException {
        float[] values = new float[3 * 5000];
        for (int i = 0; i < values.length; i++) {
            values[i] = i / 14_000f;
        }
        Film film = Film.ofScanlines(100, 50, values);
        Path file = folder.resolve("deep.png");
        ImageFile.write(file, film, ViewTransform.DEFAULT, 16);
        int[] codes = ImageIO.read(file.toFile()).getRaster().getPixels(0, 0, 100, 50, (int[]) null);
        float[] read = ImageFile.read(file).toScanlines();
        for (int i = 0; i < values.length; i++) {
            double value = Math.min(values[i], 1);
            assertThat(value).isBetween(SrgbCurve.toLinear((codes[i] - 0.5) / 65535) - 1e-12,
                    SrgbCurve.toLinear((codes[i] + 0.5) / 65535) + 1e-12);
            assertThat(read[i]).isEqualTo((float) SrgbCurve.toLinear(codes[i] / 65535.0));
        }
    }

    /** A gray code is the same light as three equal codes of a color; Java's own conversion would take it as linear. */
    @ParameterizedTest
    @ValueSource(ints = {BufferedImage.TYPE_BYTE_GRAY, BufferedImage.TYPE_3BYTE_BGR})
    void grayPng_isDecodedLikeColor(int type) throws IOException {
        var image = new BufferedImage(1, 1, type);
        Arrays.stream(new int[] {0, 1, 2}).limit(image.getRaster().getNumBands()).forEach(c -> image.getRaster().setSample(0, 0, c, 128));
        Path file = folder.resolve("gray.png");
        ImageIO.write(image, "png", file.toFile());
        assertThat(ImageFile.read(file).green(0, 0)).isEqualTo((float) SrgbCurve.toLinear(128 / 255.0));
    }

    @Test
    void unsupportedBitDepth_isRejected() {
        assertThatIOException().isThrownBy(() -> ImageFormat.XPM.requireBitDepth(Path.of("a.xpm"), 16))
                .withMessage("a.xpm: this format has 8 bits, not 16");
    }

    @Test
    void xpm_supportsManyColors() throws IOException {
        Film film = RandomFilms.anyCodes(300, 250, 7);

        assertThat(Arrays.stream(displayed(film)).distinct().count()).isGreaterThan(70_000);
        assertThat(writtenXpm(film)).containsExactly(rgb(film));
    }

    @Test
    void xpmOfTwoPixels_hasExpectedText() throws IOException {
        Film film = Film.ofScanlines(2, 1, new float[] {1, 1, 1, 0, 0, 1});
        Path file = folder.resolve("two.xpm");
        ImageFile.write(file, film, ViewTransform.DEFAULT);

        assertThat(file).hasContent("""
                /* XPM */
                static char *picture[] = {
                "2 1 2 1",
                "A c #0000ff",
                "B c #ffffff",
                "BA"
                };
                """);
    }

    @Test
    void pfm_isLittleEndianBottomUp() throws IOException {
        Film film = Film.ofScanlines(1, 2, new float[] {1, 2, 3, 4, 5, 6});
        Path file = folder.resolve("two.pfm");
        ImageFile.write(file, film, ViewTransform.DEFAULT);
        byte[] bytes = Files.readAllBytes(file);

        assertThat(new String(bytes, 0, 12, StandardCharsets.US_ASCII)).isEqualTo("PF\n1 2\n-1.0\n");
        assertThat(bytes).hasSize(12 + 24);
        // 4.0f is 0x40800000.
        assertThat(new byte[] {bytes[12], bytes[13], bytes[14], bytes[15]}).containsExactly(0, 0, 0x80, 0x40);
    }

    @Test
    void bigEndianPfm_isRead() throws IOException {
        Path file = folder.resolve("big.pfm");
        byte[] header = "PF\n1 1\n1.0\n".getBytes(StandardCharsets.US_ASCII);
        byte[] bytes = Arrays.copyOf(header, header.length + 12);
        bytes[header.length] = 0x40;
        Files.write(file, bytes);

        assertThat(ImageFile.read(file).red(0, 0)).isEqualTo(2);
    }

    @Test
    void png_isReadableByImageIo() throws IOException {
        Path file = folder.resolve("other.png");
        ImageFile.write(file, RandomFilms.gray(3, 2, 0.25f), new ViewTransform(1));
        BufferedImage image = ImageIO.read(file.toFile());

        assertThat(image.getWidth()).isEqualTo(3);
        assertThat(image.getHeight()).isEqualTo(2);
        assertThat(image.getRGB(2, 1)).isEqualTo(0xFFBCBCBC);
    }

    @Test
    void exposure_leavesPfmUnchanged() throws IOException {
        Film film = RandomFilms.anyBits(5, 5, 3);
        Path file = folder.resolve("dark.pfm");
        ImageFile.write(file, film, new ViewTransform(-3));

        assertThat(ImageFile.read(file).hasSameBits(film)).isTrue();
    }

    @Test
    void unknownExtension_isRejectedWithTheKnownOnes() {
        Path file = folder.resolve("picture.jpg");

        assertThatIOException().isThrownBy(() -> ImageFile.write(file, Film.black(1, 1), ViewTransform.DEFAULT))
                .withMessage(file + ": an image's name must end in .png, .xpm, .pfm, .exr or .hdr");
        assertThatIOException().isThrownBy(() -> ImageFormat.of(Path.of("/")));
        assertThat(folder).isEmptyDirectory();
    }

    @Test
    void missingFile_isReported() {
        Path file = folder.resolve("none.png");

        assertThatIOException().isThrownBy(() -> ImageFile.read(file)).withMessage(file + ": no such file");
    }

    @Test
    void hugeSize_isRejectedFromTheHeader() throws IOException {
        Path pfm = Files.writeString(folder.resolve("huge.pfm"), "PF\n16385 1\n-1\n");
        Path png = folder.resolve("huge.png");
        ImageFile.write(png, Film.black(1, 1), ViewTransform.DEFAULT);
        byte[] bytes = Files.readAllBytes(png);
        bytes[18] = 0x7F;
        fixHeaderChecksum(bytes);
        Files.write(png, bytes);

        for (Path file : new Path[] {pfm, png}) {
            assertThatIOException().isThrownBy(() -> ImageFile.read(file))
                    .withMessageContaining(file + ": must have from 1 to 16384 pixels along each side, has ");
        }
    }

    @Test
    void truncatedFile_isRejected() throws IOException {
        Path pfm = Files.writeString(folder.resolve("cut.pfm"), "PF\n4000 4000\n-1\nabc");

        assertThatIOException().isThrownBy(() -> ImageFile.read(pfm)).withMessageContaining("truncated");
    }

    @Property(tries = 600)
    void damagedFile_isReportedByName(@ForAll long seed) throws IOException {
        Random random = new Random(seed);
        String extension = new String[] {".png", ".pfm"}[random.nextInt(2)];
        try (TryFolder files = new TryFolder()) {
            Path file = files.file("damaged" + extension);
            ImageFile.write(file, RandomFilms.anyCodes(9, 7, 1), ViewTransform.DEFAULT);
            byte[] bytes = Files.readAllBytes(file);
            for (int i = random.nextInt(6); i >= 0; i--) {
                bytes[random.nextInt(Math.min(bytes.length, 200))] = (byte) random.nextInt();
            }
            Files.write(file, Arrays.copyOf(bytes, bytes.length - random.nextInt(40)));
            assertIsReadOrReported(file);
        }
    }

    private static void assertIsReadOrReported(Path file) {
        try {
            assertThat(ImageFile.read(file).width()).isPositive();
        } catch (IOException e) {
            assertThat(e).hasMessageStartingWith(file + ": ");
        }
    }

    @Test
    void xpm_isNotRead() throws IOException {
        Path file = folder.resolve("a.xpm");
        ImageFile.write(file, Film.black(1, 1), ViewTransform.DEFAULT);

        assertThatIOException().isThrownBy(() -> ImageFile.read(file))
                .withMessage(file + ": an image's name must end in .png, .jpg, .pfm, .exr or .hdr");
    }

    @Test
    void exrHeader_determinesFullFloats() throws IOException {
        // Halves represent every value of a black image.
        Path halves = folder.resolve("halves.exr");
        Path floats = folder.resolve("floats.exr");
        ImageFile.write(halves, Film.black(1, 1), ViewTransform.DEFAULT, 16);
        ImageFile.write(floats, Film.black(1, 1), ViewTransform.DEFAULT, 32);

        assertThat(ImageFile.readPicture(halves, ImageSource::hasFullFloats)).isFalse();
        assertThat(ImageFile.readPicture(floats, ImageSource::hasFullFloats)).isTrue();
    }

    /** Returns the pixels of an XPM file, read by a minimal parser. */
    private static int[] writtenXpm(Film film) throws IOException {
        try (TryFolder files = new TryFolder()) {
            Path file = files.file("picture.xpm");
            ImageFile.write(file, film, ViewTransform.DEFAULT);
            List<String> strings = Files.readAllLines(file).stream().filter(line -> line.startsWith("\""))
                    .map(line -> line.substring(1, line.lastIndexOf('"'))).toList();
            int[] sizes = Arrays.stream(strings.getFirst().split(" ")).mapToInt(Integer::parseInt).toArray();
            int name = sizes[3];
            Map<String, Integer> palette = new HashMap<>();
            for (String color : strings.subList(1, 1 + sizes[2])) {
                palette.put(color.substring(0, name), Integer.parseInt(color.substring(color.indexOf('#') + 1), 16));
            }
            List<String> rows = strings.subList(1 + sizes[2], strings.size());
            assertThat(rows).hasSize(sizes[1]).allMatch(row -> row.length() == name * sizes[0]);
            return rows.stream().flatMapToInt(row -> IntStream.range(0, sizes[0])
                    .map(x -> palette.get(row.substring(name * x, name * x + name)))).toArray();
        }
    }

    private static int[] rgb(Film film) {
        return Arrays.stream(displayed(film)).map(pixel -> pixel & 0xFFFFFF).toArray();
    }

    private static Film writtenAndRead(String name, Film film) throws IOException {
        try (TryFolder files = new TryFolder()) {
            ImageFile.write(files.file(name), film, ViewTransform.DEFAULT);
            return ImageFile.read(files.file(name));
        }
    }

    private static int[] displayed(Film film) {
        return ViewTransform.DEFAULT.toPixels(film);
    }

    /** Fixes the checksum after bytes 12 to 28, the header chunk's name and content. */
    private static void fixHeaderChecksum(byte[] png) {
        var crc = new java.util.zip.CRC32();
        crc.update(png, 12, 17);
        java.nio.ByteBuffer.wrap(png).putInt(29, (int) crc.getValue());
    }

    @Provide
    Arbitrary<Film> films() {
        return RandomFilms.anyBits();
    }
}
