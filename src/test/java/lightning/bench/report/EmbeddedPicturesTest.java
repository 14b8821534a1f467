package lightning.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import lightning.bench.result.BenchResults;
import lightning.bench.result.EditResult;
import lightning.bench.result.SampleResults;
import lightning.bench.result.SceneResult;
import lightning.bench.result.SweepPointResult;
import lightning.bench.result.ValueResult;
import lightning.format.image.ImageFile;
import lightning.render.image.DifferenceImage;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.render.measure.AccuracySetting;
import lightning.render.measure.PictureError;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class EmbeddedPicturesTest {
    private static final PictureError ERROR = new PictureError(1, 3, 1, 0.1, 0.1, 0.1, 20, 20, 0.9, 0.1);

    @TempDir
    private Path folder;

    private EmbeddedPictures pictures(String before, String picture, String difference) {
        var point = new SweepPointResult(AccuracySetting.EXACT, SampleResults.samples(1), 0, ERROR, null, picture, difference);
        var edit = new EditResult("color", "", 0, 0, 0, List.of(new ValueResult("red", List.of(point))));
        var scene = new SceneResult("bird", 8, 6, 1, 1, 1, before, null, List.of(edit), List.of(), null, null);
        return EmbeddedPictures
                .of(new BenchResults(SampleResults.RUN, List.of(scene), List.of(), List.of(), List.of(), List.of(), List.of(),
                        List.of()), folder);
    }

    @Test
    void equalPictures_areEmbeddedOnce() throws IOException {
        write("a.png", gray(0.5f));
        write("b.png", gray(0.5f));
        write("c.png", gray(0.6f));
        EmbeddedPictures equal = pictures("a.png", "b.png", null);

        assertThat(equal.blockOfFile()).containsOnlyKeys("a.png", "b.png");
        assertThat(equal.blockOfFile().get("a.png")).isEqualTo(equal.blockOfFile().get("b.png"));
        assertThat(equal.blocks().lines()).hasSize(1);
        assertThat(pictures("a.png", "c.png", null).blocks().lines()).hasSize(2);
    }

    @Test
    void missingPicture_isOmitted() throws IOException {
        Files.writeString(folder.resolve("text.png"), "no picture");

        for (EmbeddedPictures none : List.of(pictures(null, null, null), pictures("missing.png", "text.png", "no\0path"))) {
            assertThat(none.blockOfFile()).isEmpty();
            assertThat(none.blocks()).isEmpty();
        }
    }

    @Test
    void falseColors_arePreserved() throws IOException {
        Film film = DifferenceImage.of(gray(0.5f), gray(0.6f));
        write("d.png", film);
        EmbeddedPictures pictures = pictures(null, null, "d.png");
        Matcher data = Pattern.compile("<script type=\"text/plain\" id=\"" + pictures.blockOfFile().get("d.png")
                + "\">data:image/png;base64,([^<]*)</script>").matcher(pictures.blocks());

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
        Arrays.fill(rgb, value);
        return Film.ofScanlines(8, 6, rgb);
    }
}
