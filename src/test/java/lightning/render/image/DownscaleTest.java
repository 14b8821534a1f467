package lightning.render.image;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class DownscaleTest {
    @Test
    void size_isLargestThatFits() {
        assertThat(Downscale.fit(1920, 1080, 256, 72)).isEqualTo(new Downscale(128, 72));
        assertThat(Downscale.fit(1000, 10, 256, 72)).isEqualTo(new Downscale(256, 3));
        assertThat(Downscale.fit(10_000, 1, 256, 72)).isEqualTo(new Downscale(256, 1));
        assertThat(Downscale.fit(64, 48, 256, 72)).isEqualTo(new Downscale(64, 48));
    }

    @Test
    void pixel_isMeanOfCoveredPixels() {
        Film film = Film.ofScanlines(4, 2, new float[] {1, 0, 0, 3, 0, 0, 0, 8, 0, 0, 0, 0, 5, 0, 4, 7, 0, 0, 0, 0, 0, 0, 0, 0});
        Film small = new Downscale(2, 1).apply(film);
        assertThat(small.red(0, 0)).isEqualTo(4);
        assertThat(small.blue(0, 0)).isEqualTo(1);
        assertThat(small.green(1, 0)).isEqualTo(2);
    }

    @Test
    void fittingFilm_isUnchanged() {
        Film film = Film.black(30, 20);
        assertThat(new Downscale(30, 20).apply(film)).isSameAs(film);
    }

    /** Every pixel is covered exactly once: if sizes divide, the mean of equal shares shows it. */
    @Property
    void mean_isPreservedForDivisibleSizes(@ForAll @IntRange(min = 1, max = 9) int width, @ForAll @IntRange(min = 1, max = 9) int height,
            @ForAll @IntRange(min = 2, max = 6) int times) {
        float[] rgb = new float[3 * width * height * times * times];
        long sum = 0;
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = i % 13;
            sum += i % 13;
        }
        Film small = new Downscale(width, height).apply(Film.ofScanlines(width * times, height * times, rgb));
        double found = 0;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                found += small.red(x, y) + small.green(x, y) + small.blue(x, y);
            }
        }
        assertThat(found * times * times).isCloseTo(sum, org.assertj.core.data.Percentage.withPercentage(0.001));
    }
}
