package lightning.bench;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.render.image.Film;
import org.junit.jupiter.api.Test;

class FilmDownscalerTest {
    /** Returns a film whose red counts pixels from 0, and whose green is 1 only at pixel (1, 1). */
    private static Film film(int width, int height) {
        Film film = Film.black(width, height);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                film.red(y / 32 * film.tilesX() + x / 32)[Film.pixelInTile(x, y)] = x + y * width;
            }
        }
        film.green(0)[33] = 1;
        return film;
    }

    @Test
    void average_isMeanOfSquare() {
        Film small = FilmDownscaler.average(film(4, 4), 2);
        assertThat(small.width()).isEqualTo(2);
        assertThat(small.height()).isEqualTo(2);
        assertThat(small.red(0, 0)).isEqualTo((0 + 1 + 4 + 5) / 4f);
        assertThat(small.red(1, 1)).isEqualTo((10 + 11 + 14 + 15) / 4f);
        assertThat(small.green(0, 0)).isEqualTo(0.25f);
    }

    @Test
    void maximum_keepsSinglePixel() {
        Film small = FilmDownscaler.maximum(film(4, 4), 2);
        assertThat(small.green(0, 0)).isEqualTo(1);
        assertThat(small.red(1, 1)).isEqualTo(15);
    }

    @Test
    void width_isAtMostMaxWidth() {
        assertThat(FilmDownscaler.average(film(97, 65), 32).width()).isEqualTo(24);
        assertThat(FilmDownscaler.average(film(97, 65), 32).height()).isEqualTo(16);
        assertThat(FilmDownscaler.average(film(100, 1), 10).width()).isEqualTo(100);
    }

    @Test
    void narrowPicture_isUnchanged() {
        Film film = film(32, 50);
        assertThat(FilmDownscaler.average(film, 32)).isSameAs(film);
        assertThat(FilmDownscaler.maximum(film, 40)).isSameAs(film);
    }
}
