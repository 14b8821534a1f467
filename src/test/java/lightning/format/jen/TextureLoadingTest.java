package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.zip.CRC32;
import javax.imageio.ImageIO;
import lightning.format.jen.asset.TextureFile;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureUsage;
import lightning.scene.material.Material;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class TextureLoadingTest {
    @TempDir
    Path root;
    private Path scenes;

    @BeforeEach
    void makeFolder() throws IOException {
        scenes = Files.createDirectories(root.resolve("project/scenes"));
    }

    @Test
    void textureNextToScene_isUsed() throws Exception {
        write(scenes.resolve("a.png"), 3, 2);
        assertThat(load("a.png").width()).isEqualTo(3);
    }

    @ParameterizedTest
    @ValueSource(strings = {"scenes/textures", "textures"})
    void textureInTexturesFolder_isUsed(String folder) throws Exception {
        Path textures = Files.createDirectories(root.resolve("project").resolve(folder).resolve("sub"));
        write(textures.resolve("a.png"), 3, 2);
        assertThat(load("sub/a.png").height()).isEqualTo(2);
    }

    @Test
    void readingAFile_searchesItsFolder() throws Exception {
        write(scenes.resolve("a.png"), 3, 2);
        Path file = Files.writeString(scenes.resolve("s.jen"), "jen 1 material m { texture \"a.png\" repeat 4 -2 }");
        Material m = JenReader.read(file).scene().materials().getFirst();
        assertThat(m.texture()).hasValueSatisfying(t -> {
            assertThat(t.file()).isEqualTo("a.png");
            assertThat(t.repeatU()).isEqualTo(4);
            assertThat(t.repeatV()).isEqualTo(-2);
        });
    }

    @Test
    void repeatedFile_isDecodedOnce() throws Exception {
        write(scenes.resolve("a.png"), 3, 2);
        List<Material> m = JenReader.read("jen 1 material a { texture \"a.png\" } material b { texture \"a.png\" repeat 2 2 }",
                "s.jen", scenes).scene().materials();
        assertThat(m.get(0).texture().orElseThrow().image()).isSameAs(m.get(1).texture().orElseThrow().image());
    }

    @ParameterizedTest
    @CsvSource({"0,0", "10,0.0030352698", "11,0.0033465358", "55,0.038204372", "128,0.2158605", "255,1"})
    void samples_areDecodedFromSrgb(int sample, double linear) throws Exception {
        // Expected values: the formula of IEC 61966-2-1, computed by another program.
        var image = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, sample << 8);
        ImageIO.write(image, "png", scenes.resolve("a.png").toFile());
        Texture t = load("a.png");
        assertThat((double) t.channel(0, 0, 1)).isEqualTo(linear, within(2e-8));
        assertThat(t.channel(0, 0, 0)).isZero();
    }

    /** JPEG files of 200, 100, 50 by the inks 0, 128, 191 and 55 of 255, with and without chroma. */
    @ParameterizedTest
    @ValueSource(strings = {"inks.jpg", "inks-chroma.jpg"})
    void fourInks_areColors(String name) throws Exception {
        Files.copy(Path.of("src/test/resources/lightning/format/jen", name), scenes.resolve("a.jpg"));
        Texture texture = load("a.jpg");
        int[] expected = {200, 100, 50};
        for (int c = 0; c < 3; c++) {
            assertThat(255 * Math.pow(texture.channel(3, 3, c), 1 / 2.2)).as("channel %s", c).isCloseTo(expected[c], within(4.0));
        }
    }

    /** A color that counts as transparent is a chunk of its own beside gray and RGB pixels. */
    @Test
    void transparentColor_isAlpha() throws Exception {
        var image = new BufferedImage(2, 1, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, 0x102030);
        var out = new ByteArrayOutputStream();
        ImageIO.write(image, "png", out);
        byte[] transparent = withChunk(out.toByteArray(), "tRNS", new byte[] {0, 0x10, 0, 0x20, 0, 0x30});
        assertThat(TextureFile.hasAlpha(out.toByteArray())).isFalse();
        assertThat(TextureFile.hasAlpha(transparent)).isTrue();
        Texture opacity = TextureFile.decode("a", transparent, TextureUsage.OPACITY);
        assertThat(new float[] {opacity.channel(0, 0, 0), opacity.channel(1, 0, 0)}).containsExactly(0, 1);
    }

    /** Inserts a chunk after the header of a PNG file. */
    private static byte[] withChunk(byte[] png, String type, byte[] data) {
        int header = 8 + 25;
        ByteBuffer out = ByteBuffer.allocate(png.length + 12 + data.length).put(png, 0, header);
        byte[] name = type.getBytes(StandardCharsets.US_ASCII);
        var sum = new CRC32();
        sum.update(name);
        sum.update(data);
        return out.putInt(data.length).put(name).put(data).putInt((int) sum.getValue()).put(png, header, png.length - header).array();
    }

    @ParameterizedTest
    @ValueSource(ints = {BufferedImage.TYPE_INT_RGB, BufferedImage.TYPE_INT_ARGB, BufferedImage.TYPE_3BYTE_BGR,
        BufferedImage.TYPE_BYTE_GRAY, BufferedImage.TYPE_USHORT_GRAY, BufferedImage.TYPE_BYTE_INDEXED, BufferedImage.TYPE_BYTE_BINARY})
    void everyPngType_isDecodedTopDown(int type) throws Exception {
        var image = new BufferedImage(2, 3, type);
        image.setRGB(1, 0, 0xFFFFFFFF);
        ImageIO.write(image, "png", scenes.resolve("a.png").toFile());
        Texture t = load("a.png");
        for (int channel = 0; channel < 3; channel++) {
            assertThat(t.channel(1, 0, channel)).isEqualTo(1);
            assertThat(t.channel(0, 0, channel)).isZero();
            assertThat(t.channel(1, 2, channel)).isZero();
        }
    }

    @Test
    void graySample_isDecodedLikeColor() throws Exception {
        var image = new BufferedImage(1, 1, BufferedImage.TYPE_BYTE_GRAY);
        image.getRaster().setSample(0, 0, 0, 128);
        ImageIO.write(image, "png", scenes.resolve("a.png").toFile());
        assertThat(load("a.png").channel(0, 0, 2)).isEqualTo(0.2158605f, within(2e-8f));
    }

    @Test
    void jpeg_isDecoded() throws Exception {
        var image = new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 64; i++) {
            image.setRGB(i % 8, i / 8, 0xFFFFFF);
        }
        ImageIO.write(image, "jpeg", scenes.resolve("a.jpg").toFile());
        assertThat(load("a.jpg").channel(4, 4, 1)).isEqualTo(1, within(0.02f));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "/etc/a.png | was the absolute path",
        "../a.png | a path without empty names, . and ..",
        "x/../../a.png | a path without empty names, . and ..",
        "./a.png | a path without empty names, . and ..",
        "a//b.png | a path without empty names, . and ..",
        "a\\\\b.png | must be a file name of 1 to 200 letters",
        "C:a.png | must be a file name of 1 to 200 letters",
        "`` | must be a file name of 1 to 200 letters",
    })
    void nameOutsideFolder_isRejected(String name, String message) throws Exception {
        write(root.resolve("project/a.png"), 1, 1);
        assertThat(problem(name)).startsWith("s.jen:1:28: material 'm': texture ").contains(message);
    }

    @Test
    void linkOutOfFolder_isRejected() throws Exception {
        write(root.resolve("secret.png"), 1, 1);
        Files.createSymbolicLink(scenes.resolve("a.png"), root.resolve("secret.png"));
        Files.createSymbolicLink(scenes.resolve("sub"), root);
        Files.createSymbolicLink(scenes.resolve("textures"), root);
        assertThat(problem("a.png")).contains("found a link to another folder");
        assertThat(problem("sub/secret.png")).contains("found a link to another folder");
        assertThat(problem("secret.png")).contains("must be inside the folder 'textures', found a link to another folder");
    }

    @Test
    void linkInsideFolder_isFollowed() throws Exception {
        write(scenes.resolve("b.png"), 5, 1);
        Files.createSymbolicLink(scenes.resolve("a.png"), scenes.resolve("b.png"));
        assertThat(load("a.png").width()).isEqualTo(5);
    }

    @Test
    void missingFile_isReportedWithLocation() {
        assertThat(problem("a.png")).isEqualTo("s.jen:1:28: material 'm': there is no texture 'a.png' in the folder 'scenes'; left out");
    }

    @Test
    void folder_isRejected() throws Exception {
        Files.createDirectory(scenes.resolve("a.png"));
        assertThat(problem("a.png")).contains("there is no texture");
    }

    @Test
    void otherFileTypes_areRejected() throws Exception {
        ImageIO.write(new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB), "bmp", scenes.resolve("a.png").toFile());
        assertThat(problem("a.png")).contains("must be a PNG or JPEG file, found an unsupported format");
        Files.write(scenes.resolve("a.png"), new byte[0]);
        assertThat(problem("a.png")).contains("must be a PNG or JPEG file, found an unsupported format");
    }

    @Test
    void hugeSize_isRejectedBeforeDecoding() throws Exception {
        Files.write(scenes.resolve("a.png"), header(30_000, 30_000));
        assertThat(problem("a.png")).contains("from 1 to 16384 pixels along each side, has 30000×30000");
    }

    @Test
    void jpegWithManyScans_isRejectedBeforeDecoding() throws Exception {
        Files.write(scenes.resolve("a.jpg"), ManyScans.jpeg(16, 16, 100));
        assertThat(load("a.jpg").width()).isEqualTo(16);
        Files.write(scenes.resolve("a.jpg"), ManyScans.jpeg(16, 16, 300));
        assertThat(problem("a.jpg")).contains("texture 'a.jpg' must have at most 200 scans at 16×16 pixels, has 3");
        Files.write(scenes.resolve("a.jpg"), ManyScans.jpeg(4096, 4096, 70));
        assertThat(problem("a.jpg")).contains("must have at most 64 scans at 4096×4096 pixels, has 8");
    }

    @Test
    void hugeSize_isRejectedBeforeReduction() {
        assertThatThrownBy(() -> TextureFile.decode("a.png", header(30_000, 30_000), TextureUsage.COLOR))
                .hasMessageContaining("from 1 to 16384 pixels along each side, has 30000×30000");
    }

    @Test
    void scansInMetadata_areNotCounted() throws Exception {
        byte[] file = ManyScans.jpeg(16, 16, 0);
        byte[] metadata = new byte[2 + 60_000];
        metadata[0] = (byte) 0xFF;
        metadata[1] = (byte) 0xEB;
        metadata[2] = (byte) (60_000 >> 8);
        metadata[3] = (byte) 60_000;
        for (int i = 4; i < metadata.length; i++) {
            metadata[i] = (byte) (i % 2 == 0 ? 0xFF : 0xDA);
        }
        Files.write(scenes.resolve("a.jpg"), ManyScans.concat(Arrays.copyOf(file, 2), metadata, Arrays.copyOfRange(file, 2, file.length)));
        assertThat(load("a.jpg").width()).isEqualTo(16);
    }

    @Test
    void damagedFile_isReported() throws Exception {
        var random = new Random(1);
        for (String kind : List.of("png", "jpeg")) {
            var out = new ByteArrayOutputStream();
            ImageIO.write(new BufferedImage(20, 20, BufferedImage.TYPE_INT_RGB), kind, out);
            for (int i = 0; i < 300; i++) {
                byte[] bytes = out.toByteArray();
                for (int j = random.nextInt(4); j >= 0; j--) {
                    bytes[random.nextInt(bytes.length)] = (byte) random.nextInt();
                }
                Files.write(scenes.resolve("a.png"),
                        Arrays.copyOf(bytes, random.nextInt(4) == 0 ? random.nextInt(bytes.length) : bytes.length));
                try {
                    load("a.png");
                } catch (JenException e) {
                    assertThat(e.problems()).singleElement().extracting(Problem::message).asString()
                            .startsWith("material 'm': texture 'a.png' ");
                }
            }
        }
    }

    /** Returns a PNG file that ends after its header. */
    private static byte[] header(int width, int height) {
        byte[] chunk = ByteBuffer.allocate(17).put("IHDR".getBytes(StandardCharsets.US_ASCII)).putInt(width).putInt(height)
                .put(new byte[] {8, 2, 0, 0, 0}).array();
        var crc = new CRC32();
        crc.update(chunk);
        return ByteBuffer.allocate(33).putLong(0x89504E470D0A1A0AL).putInt(13).put(chunk).putInt((int) crc.getValue()).array();
    }

    private static void write(Path file, int width, int height) throws IOException {
        ImageIO.write(new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB), "png", file.toFile());
    }

    private Texture load(String name) throws JenException {
        return JenReader.read("jen 1 material m { texture \"" + name + "\" }", "s.jen", scenes).requireAllFiles().scene()
                .materials().getFirst().texture().orElseThrow().image();
    }

    private String problem(String name) {
        JenException e = JenReaderTest.catching(() -> load(name));
        assertThat(e.problems()).hasSize(1);
        return e.problems().getFirst().toString();
    }
}
