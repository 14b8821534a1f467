package lightning.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import lightning.format.image.ImageFile;
import lightning.render.image.DifferenceImage;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class EmbeddedPicturesTest {
    @TempDir
    private Path folder;

    @Test
    void equalPictures_areEmbeddedOnce() throws IOException {
        write("a.png", gray(0.5f));
        write("b.png", gray(0.5f));
        write("c.png", gray(0.6f));
        EmbeddedPictures book = new EmbeddedPictures(folder);

        assertThat(book.picture("a.png")).isEqualTo(book.picture("b.png")).isNotEqualTo(book.picture("c.png"));
        assertThat(book.styleRules().lines()).hasSize(2);
    }

    @Test
    void missingPicture_isOmitted() throws IOException {
        Files.writeString(folder.resolve("text.png"), "no picture");
        EmbeddedPictures book = new EmbeddedPictures(folder);

        assertThat(book.picture(null)).isNull();
        assertThat(book.picture("missing.png")).isNull();
        assertThat(book.picture("text.png")).isNull();
        assertThat(book.picture("no\0path")).isNull();
        assertThat(book.styleRules()).isEmpty();
    }

    @Test
    void falseColors_arePreserved() throws IOException {
        Film film = DifferenceImage.of(gray(0.5f), gray(0.6f));
        write("d.png", film);
        EmbeddedPictures book = new EmbeddedPictures(folder);
        String style = book.difference("d.png");
        Matcher data =
                Pattern.compile("\\." + style + "\\{background-image:url\\(data:image/png;base64,([^)]*)\\)}").matcher(book.styleRules());

        assertThat(data.find()).isTrue();
        int shown = ImageIO.read(new ByteArrayInputStream(Base64.getDecoder().decode(data.group(1)))).getRGB(3, 2);
        int written = ViewTransform.DEFAULT.toPixels(film)[0];
        for (int shift = 0; shift < 24; shift += 8) {
            assertThat((written >> shift & 0xFF) - (shown >> shift & 0xFF)).isBetween(0, 7);
        }
    }

    private void write(String name, Film film) throws IOException {
        ImageFile.write(folder.resolve(name), film, ViewTransform.DEFAULT);
    }

    private static Film gray(float value) {
        float[] rgb = new float[3 * 8 * 6];
        java.util.Arrays.fill(rgb, value);
        return Film.ofScanlines(8, 6, rgb);
    }
}
