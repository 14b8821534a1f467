package lightning.render.match;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import lightning.render.image.Film;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class PixelMeansTest {
    @Property(tries = 200)
    void meanOfMeans_isTheMean(@ForAll @IntRange(min = 1, max = 70) int width, @ForAll @IntRange(min = 1, max = 70) int height,
            @ForAll @IntRange(min = 1, max = 50) int columns, @ForAll @IntRange(min = 1, max = 50) int rows, @ForAll long seed) {
        float[] rgb = new float[3 * width * height];
        Random random = new Random(seed);
        double mean = 0;
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = random.nextFloat();
            mean += i % 3 == 1 ? rgb[i] / (double) (width * height) : 0;
        }
        PixelMeans.Means means = new PixelMeans(columns, rows).of(Film.ofScanlines(width, height, rgb), null);
        double found = 0;
        for (int cell = 0; cell < columns * rows; cell++) {
            assertThat(means.weights()[cell]).isCloseTo(1, within(1e-6f));
            found += means.values()[1][cell] / (double) (columns * rows);
        }
        // Each mean is rounded once to a float.
        assertThat(found).isCloseTo(mean, within(1e-7));
    }

    @Test
    void cellsOfOnePixel_areThePixels() {
        float[] rgb = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
        float[][] means = new PixelMeans(2, 2).of(Film.ofScanlines(2, 2, rgb));
        assertThat(means[0]).containsExactly(1, 4, 7, 10);
        assertThat(means[2]).containsExactly(3, 6, 9, 12);
    }

    @Test
    void pixelWithoutWeight_isLeftOut() {
        float[] rgb = {1, 1, 1, 5, 5, 5};
        PixelMeans.Means means = new PixelMeans(1, 1).of(Film.ofScanlines(2, 1, rgb), new float[] {1, 0});
        assertThat(means.values()[0]).containsExactly(1);
        assertThat(means.weights()).containsExactly(0.5f);
    }
}
