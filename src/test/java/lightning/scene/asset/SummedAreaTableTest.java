package lightning.scene.asset;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests means of rectangles against sums over pixels. */
class SummedAreaTableTest {
    private static Texture random(int width, int height) {
        Random random = new Random(7);
        float[] rgb = new float[3 * width * height];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = random.nextFloat();
        }
        return new Texture(width, height, rgb);
    }

    /** Returns the mean over a grid of points, mirrored at the edges. */
    private static double mean(Texture image, double x0, double y0, double x1, double y1, int channel) {
        int points = 600;
        double sum = 0;
        for (int j = 0; j < points; j++) {
            for (int i = 0; i < points; i++) {
                double x = mirrored(x0 + (x1 - x0) * (i + 0.5) / points);
                double y = mirrored(y0 + (y1 - y0) * (j + 0.5) / points);
                sum += image.channel((int) Math.min(x * image.width(), image.width() - 1),
                        (int) Math.min(y * image.height(), image.height() - 1),
                        channel);
            }
        }
        return sum / points / points;
    }

    private static double mirrored(double t) {
        return t < 0 ? -t : t > 1 ? 2 - t : t;
    }

    @ParameterizedTest
    @CsvSource({"0, 0, 1, 1", "0.1, 0.2, 0.4, 0.9", "-0.3, 0.5, 0.2, 1.4", "0.7, -1, 1.8, -0.2", "-0.5, -0.5, 1.5, 1.5"})
    void mean_isThatOfPixels(double x0, double y0, double x1, double y1) {
        for (Texture image : new Texture[] {random(5, 3), random(1, 4)}) {
            for (int c = 0; c < 3; c++) {
                assertThat((double) image.areas().mean(x0, y0, x1, y1, c)).isCloseTo(mean(image, x0, y0, x1, y1, c), within(3e-3));
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"300, 2", "3, 700", "1000, 257"})
    void largeImage_keepsItsMeans(int width, int height) {
        Texture image = random(width, height);
        assertThat((double) image.areas().mean(0, 0, 1, 1, 1)).isCloseTo(mean(image, 0, 0, 1, 1, 1), within(0.02));
        assertThat((double) image.areas().mean(0.25, 0.5, 0.75, 1, 2)).isCloseTo(mean(image, 0.25, 0.5, 0.75, 1, 2), within(0.02));
    }

    @Test
    void constantImage_isConstantEverywhere() {
        Texture image = new Texture(7, 5, filled(105, 0.3f));
        for (double x = -0.9; x < 1; x += 0.07) {
            assertThat(image.areas().mean(x, x / 2, x + 0.1, x / 2 + 0.3, 0)).isEqualTo(0.3f);
        }
    }

    @Test
    void meanBesideVeryBrightPixels_isNeverNegative() {
        float[] rgb = filled(300 * 300 * 3, 0);
        rgb[0] = 1e6f;
        SummedAreaTable areas = new Texture(300, 300, rgb).areas();
        assertThat(areas.max()).isEqualTo(1e6f);
        for (double x = 0.01; x < 0.9; x += 0.013) {
            assertThat(areas.mean(x, 0.3, x + 0.1, 0.4, 0)).isBetween(0f, 1e-9f);
        }
    }

    private static float[] filled(int length, float value) {
        float[] values = new float[length];
        java.util.Arrays.fill(values, value);
        return values;
    }
}
