package lightning.textures;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import lightning.format.image.ImageFile;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.render.image.ViewTransform;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

@Slow
class TextureGeneratorTest {

    private static final Path TEXTURES = Path.of("textures");
    private static final int SMALL = 64;

    @ParameterizedTest
    @EnumSource
    void repeatedRender_isDeterministic(TextureGenerator.TextureName name) {
        Film once = TextureGenerator.render(name.pattern, SMALL);

        FilmAssert.assertSameBits(TextureGenerator.render(name.pattern, SMALL), once, "texture-" + name);
    }

    @ParameterizedTest
    @EnumSource
    void oppositeBorders_tileSeamlessly(TextureGenerator.TextureName name) throws IOException {
        Film film = ImageFile.read(TEXTURES.resolve(name.fileName()));
        List<Double> columns = new ArrayList<>();
        List<Double> rows = new ArrayList<>();
        for (int i = 0; i < film.width() - 1; i++) {
            columns.add(columnStep(film, i, i + 1));
            rows.add(rowStep(film, i, i + 1));
        }

        assertThat(columnStep(film, film.width() - 1, 0)).isLessThanOrEqualTo(columns.stream().max(Double::compare).get());
        assertThat(rowStep(film, film.height() - 1, 0)).isLessThanOrEqualTo(rows.stream().max(Double::compare).get());
    }

    @ParameterizedTest
    @EnumSource
    void committedPicture_hasGeneratedSize(TextureGenerator.TextureName name) throws IOException {
        Path file = TEXTURES.resolve(name.fileName());

        assertThat(Files.size(file)).isLessThan(500 * 1024);
        assertThat(ImageFile.read(file).width()).isEqualTo(TextureGenerator.SIZE);
        assertThat(ImageFile.read(file).height()).isEqualTo(TextureGenerator.SIZE);
    }

    @ParameterizedTest
    @EnumSource
    void everyTexture_hasContrast(TextureGenerator.TextureName name) throws IOException {
        Film film = ImageFile.read(TEXTURES.resolve(name.fileName()));
        double sum = 0;
        double squares = 0;
        for (float value : film.toScanlines()) {
            sum += value;
            squares += (double) value * value;
        }
        double count = 3.0 * film.width() * film.height();
        double mean = sum / count;

        assertThat(mean).isBetween(0.01, 0.9);
        assertThat(Math.sqrt(squares / count - mean * mean)).isGreaterThan(0.02);
    }

    @Test
    void committedPicture_matchesGenerator() throws IOException {
        Film painted = TextureGenerator.render(TextureGenerator.TextureName.METAL_PLATES.pattern, TextureGenerator.SIZE);
        Film committed = ImageFile.read(TEXTURES.resolve(TextureGenerator.TextureName.METAL_PLATES.fileName()));

        assertThat(ViewTransform.DEFAULT.toPixels(committed)).isEqualTo(ViewTransform.DEFAULT.toPixels(painted));
    }

    /** Returns the mean absolute difference of two pixel columns. */
    private static double columnStep(Film film, int from, int to) {
        double sum = 0;
        for (int y = 0; y < film.height(); y++) {
            sum += step(film, from, y, to, y);
        }
        return sum / film.height();
    }

    private static double rowStep(Film film, int from, int to) {
        double sum = 0;
        for (int x = 0; x < film.width(); x++) {
            sum += step(film, x, from, x, to);
        }
        return sum / film.width();
    }

    private static double step(Film film, int x, int y, int toX, int toY) {
        return Math.abs(film.red(x, y) - film.red(toX, toY)) + Math.abs(film.green(x, y) - film.green(toX, toY))
                + Math.abs(film.blue(x, y) - film.blue(toX, toY));
    }
}
