package lightning.render.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/**
 * Tests ꟻLIP against three kinds of values: computed by hand from its definition (flat pictures, where no filter has an effect),
 * from the authors' own implementation (flip-evaluator 1.7, run on the pictures generated here), and mathematical laws.
 */
class FlipTest {

    /**
     * Tolerance of a mean against the authors' implementation, which computes in 32 bits. One unit in the last place of L* (6e-6)
     * changes an error by 2e-4 where colors hardly differ, and one of the features (6e-8) changes the exponent as much.
     */
    private static final double MEAN_TOLERANCE = 5e-5;
    /** Tolerance of the error of one pixel. */
    private static final double PIXEL_TOLERANCE = 2e-4;

    @Test
    void blackAndWhite_differByLightness100() {
        // L* 0 and 100, no chroma. Green is L*a*b* (87.736, −86.179, 83.183), blue (32.298, 79.194, −107.859), Hunt scales
        // their chroma by 0.87736 and 0.32298: the largest distance is 55.438 + |(−101.188, 107.818)| = 203.302.
        double largest = Math.pow(203.302, 0.7);
        double expected = 0.95 + (Math.pow(100, 0.7) - 0.4 * largest) / (0.6 * largest) * 0.05;

        assertThat(Flip.mean(flat(0), flat(0xFFFFFF))).isCloseTo(expected, within(1e-6));
    }

    @Test
    void similarGrays_differOnSteepPart() {
        // Codes 128 and 136 are 0.215861 and 0.246201 linear: L* 53.5850 and 56.7034.
        double expected = 0.95 * Math.pow(56.7034 - 53.5850, 0.7) / (0.4 * Math.pow(203.302, 0.7));

        assertThat(Flip.mean(flat(0x808080), flat(0x888888))).isCloseTo(expected, within(1e-6));
    }

    @Test
    void greenAndBlue_haveMaximumError() {
        assertThat(Flip.mean(flat(0x00FF00), flat(0x0000FF))).isCloseTo(1, within(1e-6));
    }

    @Test
    void flatImages_haveUniformError() {
        for (float error : Flip.errors(flat(0xC86432), flat(0x3264C8), Flip.PIXELS_PER_DEGREE)) {
            // The authors' implementation.
            assertThat(error).isCloseTo(0.952227f, within((float) PIXEL_TOLERANCE));
        }
    }

    @Test
    void noise_matchesReferenceImplementation() {
        assertMatchesReference(noise(1), noise(2), 67.0206, 0.457415, 0.389117);
    }

    @Test
    void noiseFromNear_matchesReferenceImplementation() {
        assertMatchesReference(noise(1), noise(2), 20, 0.847571, 0.631466);
    }

    @Test
    void movedEdge_matchesReferenceImplementation() {
        Film a = codes(96, 64, (x, _) -> x >= 48 ? 0xFFFFFF : 0);
        Film b = codes(96, 64, (x, _) -> x >= 50 ? 0xFFFFFF : 0);

        assertMatchesReference(a, b, 67.0206, 0.055599, 0);
        assertThat(largest(a, b)).isCloseTo(0.975001f, within((float) PIXEL_TOLERANCE));
    }

    @Test
    void differentRamp_matchesReferenceImplementation() {
        assertMatchesReference(codes(128, 100, (x, y) -> rgb(2 * x, y, 255 - 2 * x)),
                codes(128, 100, (x, y) -> rgb(2 * x, Math.min(y + 16, 255), 255 - x)), 67.0206, 0.487072, 0.224351);
    }

    @Test
    void brightPixel_matchesReferenceImplementation() {
        assertMatchesReference(codes(64, 64, (_, _) -> rgb(60, 60, 60)),
                codes(64, 64, (x, y) -> x == 10 && y == 20 ? rgb(210, 160, 60) : rgb(60, 60, 60)), 67.0206, 0.0019351, 0.399431);
    }

    @Test
    void imagesWithSameDisplay_haveNoError() {
        Film film = RandomFilms.gray(40, 30, 0.5f);

        assertThat(Flip.mean(film, RandomFilms.withGreen(film, 3, 3, Math.nextUp(0.5f)))).isZero();
    }

    @Property(tries = 30)
    void imageAndCopy_haveNoError(@ForAll @IntRange(min = 1, max = 90) int width,
            @ForAll @IntRange(min = 1, max = 90) int height, @ForAll long seed) {
        Film film = RandomFilms.anyBits(width, height, seed);

        assertThat(Flip.mean(film, film.copy())).isZero();
    }

    @Property(tries = 30)
    void errors_areBetween0And1AndSymmetric(@ForAll @IntRange(min = 1, max = 90) int width,
            @ForAll @IntRange(min = 1, max = 90) int height, @ForAll long seed) {
        Film a = RandomFilms.anyBits(width, height, seed);
        Film b = RandomFilms.anyBits(width, height, ~seed);
        float[] errors = Flip.errors(a, b, Flip.PIXELS_PER_DEGREE);

        assertThat(errors).hasSize(width * height).containsExactly(Flip.errors(b, a, Flip.PIXELS_PER_DEGREE));
        for (float error : errors) {
            assertThat(error).isBetween(0f, 1f);
        }
    }

    @Property(tries = 10)
    void bandsOfLargeImage_haveNoSeam(@ForAll long seed) {
        // Rows 60 to 80 are in two bands; upside down they are rows 39 to 59, inside one.
        Film a = RandomFilms.anyCodes(24, 140, seed);
        Film b = RandomFilms.anyCodes(24, 140, ~seed);
        float[] errors = Flip.errors(a, b, Flip.PIXELS_PER_DEGREE);
        float[] turned = Flip.errors(transposed(a), transposed(b), Flip.PIXELS_PER_DEGREE);

        for (int y = 0; y < 140; y++) {
            for (int x = 0; x < 24; x++) {
                assertThat(errors[y * 24 + x]).as("%d, %d", x, y)
                        .isCloseTo(turned[(139 - y) * 24 + x], within((float) PIXEL_TOLERANCE));
            }
        }
    }

    @Test
    void differentSizes_areRejected() {
        assertThatThrownBy(() -> Flip.mean(Film.black(2, 3), Film.black(3, 2))).hasMessageContaining("2 × 3");
    }

    @Test
    void invalidPixelsPerDegree_isRejected() {
        assertThatThrownBy(() -> Flip.mean(flat(0), flat(0), 0)).hasMessageContaining("1 to 1000");
        assertThatThrownBy(() -> Flip.mean(flat(0), flat(0), Double.NaN)).hasMessageContaining("1 to 1000");
    }

    /** Compares the mean, and the error of pixel (10, 20). */
    private static void assertMatchesReference(Film a, Film b, double pixelsPerDegree, double mean, double pixel) {
        float[] errors = Flip.errors(a, b, pixelsPerDegree);
        assertThat(Flip.mean(a, b, pixelsPerDegree)).isCloseTo(mean, within(MEAN_TOLERANCE));
        assertThat((double) errors[20 * a.width() + 10]).isCloseTo(pixel, within(PIXEL_TOLERANCE));
    }

    private static float largest(Film a, Film b) {
        float largest = 0;
        for (float error : Flip.errors(a, b, Flip.PIXELS_PER_DEGREE)) {
            largest = Math.max(largest, error);
        }
        return largest;
    }

    private static Film transposed(Film film) {
        Film turned = Film.black(film.width(), film.height());
        int[] pixels = ViewTransform.DEFAULT.toPixels(film);
        for (int y = 0; y < film.height(); y++) {
            for (int x = 0; x < film.width(); x++) {
                DisplayPixels.set(turned, x, film.height() - 1 - y, pixels[y * film.width() + x]);
            }
        }
        return turned;
    }

    /** Returns the noise of the run of the authors' implementation, computed only from 32-bit products. */
    private static Film noise(int seed) {
        return codes(97, 83, (x, y) -> rgb(hash(x, y, seed), hash(x, y, seed + 1), hash(x, y, seed + 2)));
    }

    private static int hash(int x, int y, int seed) {
        return (x * 73856093 ^ y * 19349663 ^ seed * 83492791) * (int) 2654435761L >>> 24;
    }

    private static int rgb(int red, int green, int blue) {
        return red << 16 | green << 8 | blue;
    }

    private static Film flat(int rgb) {
        return codes(40, 40, (_, _) -> rgb);
    }

    private interface Code {
        int at(int x, int y);
    }

    private static Film codes(int width, int height, Code code) {
        Film film = Film.black(width, height);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                DisplayPixels.set(film, x, y, code.at(x, y));
            }
        }
        return film;
    }
}
