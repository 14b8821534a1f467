package lightning.format.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import lightning.format.image.ImageFile;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.match.ReferenceImage;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ReferenceFileTest {
    private static final Film GRAY = Film.ofScanlines(2, 1, new float[] {0.25f, 0.25f, 0.25f, 0.5f, 0.5f, 0.5f});

    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"a.png", "a.exr", "a.pfm", "a.hdr"})
    void writtenImage_isReadAsLinearLight(String name) throws IOException {
        Path file = folder.resolve(name);
        ImageFile.write(file, GRAY, ViewTransform.DEFAULT);
        Film read = ImageFile.read(file);
        assertThat(read.red(0, 0)).isCloseTo(0.25f, within(0.004f));
        assertThat(read.blue(1, 0)).isCloseTo(0.5f, within(0.004f));
    }

    @Test
    void jpeg_isReadAsLinearLight() throws IOException {
        BufferedImage image = new BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 64; i++) {
            image.setRGB(i % 8, i / 8, 0xbcbcbc);
        }
        Path file = folder.resolve("a.JPG");
        assertThat(ImageIO.write(image, "jpeg", file.toFile())).isTrue();
        // The sRGB code 188 is 0.5029 in linear light.
        assertThat(ImageFile.read(file).green(3, 3)).isCloseTo(0.503f, within(0.01f));
        assertThat(ReferenceFile.read(file).isDisplayReferred()).isTrue();
    }

    @Test
    void clippedPixelsOfCodes_doNotCount() throws IOException {
        Film film = Film.ofScanlines(2, 1, new float[] {0.25f, 0.25f, 0.25f, 7, 0.5f, 0.5f});
        ImageFile.write(folder.resolve("a.png"), film, ViewTransform.DEFAULT);
        ImageFile.write(folder.resolve("a.exr"), film, ViewTransform.DEFAULT);
        ReferenceImage codes = ReferenceFile.read(folder.resolve("a.png")).image();
        assertThat(codes.weights()).containsExactly(1, 0);
        assertThat(ReferenceFile.read(folder.resolve("a.exr")).image().weights()).containsExactly(1, 1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"missing.png", "missing.jpg", "missing.exr", "missing.hdr", "missing.txt", "missing"})
    void missingFile_isNamed(String name) {
        assertThatIOException().isThrownBy(() -> ImageFile.read(folder.resolve(name))).withMessageContaining(name);
    }

    @ParameterizedTest
    @ValueSource(strings = {"damaged.png", "damaged.jpg", "damaged.exr", "damaged.hdr", "damaged.pfm"})
    void damagedFile_isNamed(String name) throws IOException {
        Files.writeString(folder.resolve(name), "not an image");
        assertThatIOException().isThrownBy(() -> ImageFile.read(folder.resolve(name))).withMessageContaining(name);
    }

    @Test
    void unknownEnding_namesAllThatAreRead() {
        assertThatIOException().isThrownBy(() -> ImageFile.read(folder.resolve("a.tiff")))
                .withMessageContainingAll("a.tiff", ".png, .jpg, .pfm, .exr or .hdr");
    }
}
