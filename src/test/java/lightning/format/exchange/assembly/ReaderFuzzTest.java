package lightning.format.exchange.assembly;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import lightning.base.text.PrintableText;
import lightning.format.ies.IesReader;
import lightning.format.image.CubeLutReader;
import lightning.format.image.ImageFile;
import lightning.format.image.WebpSizeTest;
import lightning.format.jen.asset.TextureFile;
import lightning.format.mesh.MeshException;
import lightning.sample.ByteFuzzer;
import lightning.sample.Slow;
import lightning.scene.asset.TextureUsage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Images, light profiles and color tables with a few errors: each is read or rejected in one sentence, in bounded time; {@link ByteFuzzer}
 * documents the options.
 */
@Slow
class ReaderFuzzTest {
    private static final int TRIES = ByteFuzzer.tryCount(5_000);
    private static final List<byte[]> HOSTILE =
            Stream.of("\u00ff\u00ff\u00ff\u007f", "\u0000\u0000\u0000\u0080", "\u00ff\u00ff", "\u0000", "-1",
                    "99999999999", "1e999", "nan", "\n", " ").map(text -> text.getBytes(StandardCharsets.ISO_8859_1)).toList();
    private static final String CUBE = "LUT_3D_SIZE 2\nDOMAIN_MIN 0 0 0\nDOMAIN_MAX 1 1 1\n" + "0 0.5 1\n".repeat(8);
    private static final String IES =
            "IESNA:LM-63-2002\n[TEST] x\nTILT=INCLUDE\n1\n2\n0 90\n1 1\n1 1000 1 3 2 1 1 0.1 0.1 0.1\n1 1 60\n0 45 90\n"
                    + "0 90\n100 90 80\n70 60 50\n";
    private static final String HDR = "#?RADIANCE\nEXPOSURE=1.0\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 8\n" + "\u0002\u0002\u0000\b"
            + "\u0088\u0010".repeat(4) + "abc\u0080".repeat(8);
    @TempDir
    private Path folder;

    private interface Reader {
        void read(byte[] content) throws IOException, MeshException;
    }

    private interface FileReader {
        void read(Path file) throws IOException, MeshException;
    }

    private static byte[] image(String format) throws IOException {
        var image = new BufferedImage(12, 10, BufferedImage.TYPE_INT_RGB);
        var random = new SplittableRandom(1);
        for (int i = 0; i < 120; i++) {
            image.setRGB(i % 12, i / 12, random.nextInt(1 << 24));
        }
        var out = new ByteArrayOutputStream();
        assertThat(ImageIO.write(image, format, out)).isTrue();
        return out.toByteArray();
    }

    @Test
    @Timeout(300)
    void textures_areReadOrRejected() throws IOException {
        assertReadOrRejected(List.of(image("png"), image("jpeg")), content -> {
            ImageFile.read("t", content, TextureFile.REDUCIBLE, image -> image.hasAlpha() ? image.texture(TextureUsage.COLOR, 1)
                    : image.texture(TextureUsage.OPACITY, 2));
        });
    }

    @Test
    @Timeout(300)
    void imagesOfOtherFormats_areConvertedOrRejected() throws IOException {
        List<byte[]> pool = new ArrayList<>();
        for (String format : List.of("bmp", "gif", "tiff")) {
            pool.add(image(format));
        }
        pool.add(WebpSizeTest.oneColor());
        assertReadOrRejected(pool, content -> ImageFile.toPng("t", content, ImageImport.CONVERTED, 1 << 20));
    }

    @Test
    @Timeout(300)
    void textFiles_areReadOrRejected() throws IOException {
        assertFilesReadOrRejected("a.cube", CUBE, CubeLutReader::read);
        assertFilesReadOrRejected("a.ies", IES, IesReader::read);
        assertFilesReadOrRejected("a.hdr", HDR, ImageFile::read);
    }

    private void assertFilesReadOrRejected(String name, String text, FileReader reader) throws IOException {
        assertReadOrRejected(List.of(text.getBytes(StandardCharsets.ISO_8859_1)),
                content -> reader.read(Files.write(folder.resolve(name), content)));
    }

    private static void assertReadOrRejected(List<byte[]> pool, Reader reader) {
        int rejected = 0;
        for (int i = 0; i < TRIES; i++) {
            byte[] content = ByteFuzzer.mutate(pool, ByteFuzzer.random(i), HOSTILE);
            try {
                reader.read(content);
            } catch (IOException | MeshException e) {
                assertThat(e.getMessage()).as("try " + i).isNotBlank().matches(PrintableText::isPrintable, "is visible")
                        .hasSizeLessThan(2000);
                rejected++;
            } catch (RuntimeException | Error e) {
                throw new AssertionError("try " + i, e);
            }
        }
        assertThat(rejected).isBetween(TRIES / 10, TRIES - 1);
    }
}
