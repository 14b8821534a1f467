package lightning.render.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import lightning.render.image.Film;
import org.junit.jupiter.api.Test;

class PictureErrorTest {
    @Test
    void equalPictures_haveNoError() {
        PictureError error = PictureError.of(Film.black(5, 4), Film.black(5, 4));
        assertThat(error).isEqualTo(new PictureError(0, 60, 0, 0, 0, 0, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, 1, 0));
    }

    @Test
    void oneDifferentValue_matchesHandComputedError() {
        Film film = Film.black(5, 4);
        film.green(0)[2] = 0.6f;
        PictureError error = PictureError.of(film, Film.black(5, 4));
        assertThat(error.values()).isEqualTo(1);
        assertThat(error.of()).isEqualTo(60);
        assertThat(error.maxAbsolute()).isEqualTo(0.6f);
        assertThat(error.meanAbsolute()).isEqualTo(0.6f / 60.0, within(1e-15));
        assertThat(error.rmse()).isEqualTo(0.6f / Math.sqrt(60), within(1e-15));
        assertThat(error.linearPsnr()).isEqualTo(20 * Math.log10(Math.sqrt(60) / 0.6f), within(1e-12));
        assertThat(error.ssim()).isLessThan(1);
    }

    @Test
    void differentSizes_areRejected() {
        assertThatThrownBy(() -> PictureError.of(Film.black(2, 2), Film.black(2, 3))).isInstanceOf(IllegalArgumentException.class);
    }
}
