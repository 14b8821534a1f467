package lightning.render.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class SsimTest {

    @Test
    void flatGrays_areComparedByLightness() {
        double a = 50;
        double b = 200;
        double c1 = 6.5025;

        assertThat(ssim(codes(30, 20, (x, y) -> 50), codes(30, 20, (x, y) -> 200)))
                .isCloseTo((2 * a * b + c1) / (a * a + b * b + c1), within(1e-9));
    }

    @Test
    void invertedChecker_isNearlyMinusOne() {
        // Means of (nearly) 127.5, and values of ±127.5 around them that are exactly negated.
        Film checker = codes(40, 40, (x, y) -> (x + y) % 2 * 255);
        Film inverted = codes(40, 40, (x, y) -> (x + y + 1) % 2 * 255);
        double variance = 127.5 * 127.5;
        double c2 = 58.5225;

        assertThat(ssim(checker, inverted)).isCloseTo((c2 - 2 * variance) / (c2 + 2 * variance), within(1e-4));
    }

    @Property(tries = 30)
    void oneWindow_matchesExplicitFormula(@ForAll long seed) {
        Film a = RandomFilms.anyCodes(11, 11, seed);
        Film b = RandomFilms.anyCodes(11, 11, seed + 1);

        assertThat(ssim(a, b)).isCloseTo(direct(a, b, 0, 0), within(1e-9));
    }

    @Property(tries = 10)
    void largerImage_isMeanOfWindows(@ForAll long seed) {
        Film a = RandomFilms.anyCodes(14, 13, seed);
        Film b = RandomFilms.anyCodes(14, 13, seed + 1);
        double sum = 0;
        for (int y = 0; y < 3; y++) {
            for (int x = 0; x < 4; x++) {
                sum += direct(a, b, x, y);
            }
        }

        assertThat(ssim(a, b)).isCloseTo(sum / 12, within(1e-9));
    }

    @Property(tries = 50)
    void everySize_hasSimilarityUpToOne(@ForAll @IntRange(min = 1, max = 14) int width,
            @ForAll @IntRange(min = 1, max = 14) int height, @ForAll long seed) {
        Film a = RandomFilms.anyCodes(width, height, seed);

        assertThat(ssim(a, RandomFilms.anyCodes(width, height, ~seed))).isBetween(-1.0, 1.0);
        assertThat(ssim(a, a.copy())).isEqualTo(1);
    }

    /** Computes the definition directly with central moments and the weights of a circular Gaussian. */
    private static double direct(Film a, Film b, int left, int top) {
        double total = 0;
        double meanA = 0;
        double meanB = 0;
        for (int y = 0; y < 11; y++) {
            for (int x = 0; x < 11; x++) {
                double w = weight(x, y);
                total += w;
                meanA += w * luma(a, left + x, top + y);
                meanB += w * luma(b, left + x, top + y);
            }
        }
        meanA /= total;
        meanB /= total;
        double varianceA = 0;
        double varianceB = 0;
        double covariance = 0;
        for (int y = 0; y < 11; y++) {
            for (int x = 0; x < 11; x++) {
                double w = weight(x, y) / total;
                double da = luma(a, left + x, top + y) - meanA;
                double db = luma(b, left + x, top + y) - meanB;
                varianceA += w * da * da;
                varianceB += w * db * db;
                covariance += w * da * db;
            }
        }
        return (2 * meanA * meanB + 6.5025) * (2 * covariance + 58.5225)
                / ((meanA * meanA + meanB * meanB + 6.5025) * (varianceA + varianceB + 58.5225));
    }

    private static double weight(int x, int y) {
        return Math.exp(-((x - 5) * (x - 5) + (y - 5) * (y - 5)) / 4.5);
    }

    private static double luma(Film film, int x, int y) {
        return 0.2126 * Srgb.formula(film.red(x, y)) + 0.7152 * Srgb.formula(film.green(x, y))
                + 0.0722 * Srgb.formula(film.blue(x, y));
    }

    private static double ssim(Film a, Film b) {
        return Ssim.displayedLuma(a, b);
    }

    private interface Code {
        int at(int x, int y);
    }

    private static Film codes(int width, int height, Code code) {
        Film film = Film.black(width, height);
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                DisplayPixels.set(film, x, y, code.at(x, y) * 0x010101);
            }
        }
        return film;
    }
}
