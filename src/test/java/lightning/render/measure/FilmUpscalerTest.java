package lightning.render.measure;

import static org.assertj.core.api.Assertions.assertThat;

import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.image.Film;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class FilmUpscalerTest {
    private static Film numbered(int width, int height) {
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = i;
        }
        return Film.ofScanlines(width, height, rgb);
    }

    private static Film upscale(Film small, int width, int height) {
        try (WorkerPool workers = new WorkerPool(1)) {
            return FilmUpscaler.upscale(small, width, height, workers, Progress.NONE);
        }
    }

    @Test
    void doubleSize_repeatsEachPixelFourTimes() {
        Film small = numbered(40, 35);
        Film large = upscale(small, 80, 70);
        for (int y = 0; y < 70; y++) {
            for (int x = 0; x < 80; x++) {
                assertThat(large.red(x, y)).isEqualTo(small.red(x / 2, y / 2));
                assertThat(large.green(x, y)).isEqualTo(small.green(x / 2, y / 2));
                assertThat(large.blue(x, y)).isEqualTo(small.blue(x / 2, y / 2));
            }
        }
    }

    /** Checks centers at 1/6, 1/2 and 5/6 of the width: in the halves 0, 1 (its border), 1. */
    @Test
    void oddSizes_useCenterPixel() {
        Film large = upscale(numbered(2, 1), 3, 1);
        assertThat(new float[] {large.red(0, 0), large.red(1, 0), large.red(2, 0)}).containsExactly(0, 3, 3);
    }

    @Property
    void sameSize_isUnchanged(@ForAll @IntRange(min = 1, max = 70) int width, @ForAll @IntRange(min = 1, max = 40) int height) {
        Film film = numbered(width, height);
        assertThat(upscale(film, width, height).hasSameBits(film)).isTrue();
    }
}
