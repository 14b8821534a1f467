package lightning.render.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class DifferenceImageTest {

    private static final int BLACK = 0xFF000000;

    @Test
    void equalFilms_areBlack() {
        Film film = RandomFilms.anyBits(40, 40, 5);

        assertThat(pixels(film, film.copy())).containsOnly(BLACK);
    }

    @Test
    void oneDifferingBit_isVisibleOnlyAtItsPixel() {
        Film film = RandomFilms.gray(40, 40, 0.5f);
        int[] pixels = pixels(film, RandomFilms.withGreen(film, 33, 2, Math.nextUp(0.5f)));

        for (int i = 0; i < pixels.length; i++) {
            if (i == 2 * 40 + 33) {
                assertThat(lightness(pixels[i])).isGreaterThan(15);
            } else {
                assertThat(pixels[i]).isEqualTo(BLACK);
            }
        }
    }

    @Test
    void largerDifferences_areLighter() {
        Film film = RandomFilms.gray(4, 4, 0.5f);
        double last = 0;
        for (float difference = 0x1p-22f; difference <= 0.5f; difference *= 4) {
            double lightness = lightness(pixels(film, RandomFilms.withGreen(film, 0, 0, 0.5f + difference))[0]);
            assertThat(lightness).isGreaterThan(last);
            last = lightness;
        }
    }

    @Test
    void nanDifferences_areLightest() {
        Film film = RandomFilms.gray(4, 4, 0.5f);

        assertThat(pixels(film, RandomFilms.withGreen(film, 0, 0, Float.NaN))[0])
                .isEqualTo(0xFF000000 | DifferenceImage.color(1));
    }

    @Test
    void negativeZero_isVisible() {
        Film film = RandomFilms.gray(4, 4, 0);

        assertThat(pixels(film, RandomFilms.withGreen(film, 0, 0, -0f))[0]).isNotEqualTo(BLACK);
    }

    @Test
    void scale_getsLighterEvenly() {
        double last = lightness(DifferenceImage.color(0));
        for (int i = 1; i <= 64; i++) {
            double lightness = lightness(DifferenceImage.color(i / 64.0));
            assertThat(lightness - last).as("step %d", i).isBetween(0.5, 3.0);
            last = lightness;
        }
    }

    @Test
    void differentSizes_areRejected() {
        assertThatThrownBy(() -> DifferenceImage.of(Film.black(2, 3), Film.black(3, 2)))
                .hasMessageContaining("2 × 3");
    }

    private static int[] pixels(Film a, Film b) {
        return ViewTransform.DEFAULT.toPixels(DifferenceImage.of(a, b));
    }

    /** CIE L*, 0…100. */
    private static double lightness(int rgb) {
        double y = 0.2126 * ViewTransform.linear(rgb >> 16 & 0xFF) + 0.7152 * ViewTransform.linear(rgb >> 8 & 0xFF)
                + 0.0722 * ViewTransform.linear(rgb & 0xFF);
        return y > 0.008856 ? 116 * Math.cbrt(y) - 16 : 903.3 * y;
    }
}
