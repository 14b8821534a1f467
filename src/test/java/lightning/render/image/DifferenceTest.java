package lightning.render.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;

class DifferenceTest {

    @Property(tries = 100)
    void filmAndCopy_haveNoDifference(@ForAll("films") Film film) {
        Difference none = Difference.of(film, film.copy());

        assertThat(none).isEqualTo(new Difference(0, 0, 0, 0, 0, 0, 0, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY,
                1, -1, -1));
        assertThat(none.isNone()).isTrue();
    }

    @Property(tries = 100)
    void noDifference_meansSameBits(@ForAll("films") Film film, @ForAll long seed) {
        Film other = RandomFilms.anyBits(film.width(), film.height(), seed);

        assertThat(Difference.of(film, other).isNone()).isEqualTo(film.hasSameBits(other));
    }

    @Property(tries = 50)
    void measures_areSymmetric(@ForAll("films") Film film, @ForAll long seed) {
        Film other = RandomFilms.anyBits(film.width(), film.height(), seed);

        assertThat(Difference.of(film, other)).isEqualTo(Difference.of(other, film));
    }

    @Test
    void constantOffset_matchesEveryMeasure() {
        Difference difference = Difference.of(RandomFilms.gray(40, 20, 0.25f), RandomFilms.gray(40, 20, 0.75f));

        assertThat(difference.pixels()).isEqualTo(800);
        assertThat(difference.values()).isEqualTo(2400);
        assertThat(difference.maxAbsolute()).isEqualTo(0.5);
        assertThat(difference.meanAbsolute()).isEqualTo(0.5);
        assertThat(difference.rmse()).isEqualTo(0.5);
        // 20·log10(2)
        assertThat(difference.linearPsnr()).isCloseTo(6.0206, within(1e-4));
        // Codes of 0.25 and 0.75: 255 · 0.537099 = 136.96 and 255 · 0.880825 = 224.61, so 137 and 225;
        // 20·log10(255 / 88)
        assertThat(difference.displayPsnr()).isCloseTo(9.2411, within(1e-4));
        // From 0.25 to 0.5 and to 1 are 2²³ floats each; 0.75 lies halfway in the second.
        assertThat(difference.maxUlp()).isEqualTo((1 << 23) + (1 << 22));
    }

    @Test
    void oneDifferingValue_isLocated() {
        Film film = RandomFilms.gray(50, 50, 0);
        Difference difference = Difference.of(film, RandomFilms.withGreen(film, 41, 7, 0.5f));

        assertThat(difference.pixels()).isEqualTo(1);
        assertThat(difference.values()).isEqualTo(1);
        assertThat(difference.x()).isEqualTo(41);
        assertThat(difference.y()).isEqualTo(7);
        assertThat(difference.meanAbsolute()).isCloseTo(0.5 / 7500, within(1e-18));
        assertThat(difference.rmse()).isCloseTo(0.5 / Math.sqrt(7500), within(1e-15));
    }

    @Test
    void largestDifference_isLocated() {
        Film film = RandomFilms.gray(40, 40, 1);
        Film other = RandomFilms.withGreen(RandomFilms.withGreen(film, 3, 3, 1.5f), 35, 36, 0);

        Difference difference = Difference.of(film, other);

        assertThat(difference.pixels()).isEqualTo(2);
        assertThat(difference.maxAbsolute()).isEqualTo(1);
        assertThat(difference.x()).isEqualTo(35);
        assertThat(difference.y()).isEqualTo(36);
    }

    @Test
    void adjacentFloats_areOneUlpApart() {
        assertThat(Difference.ulps(1, Math.nextUp(1f))).isEqualTo(1);
        assertThat(Difference.ulps(-1, Math.nextDown(-1f))).isEqualTo(1);
        assertThat(Difference.ulps(Float.MIN_VALUE, -Float.MIN_VALUE)).isEqualTo(2);
        assertThat(Difference.ulps(0, -0f)).isZero();
        assertThat(Difference.ulps(-Float.MAX_VALUE, Float.POSITIVE_INFINITY)).isEqualTo(2L * 0x7F7FFFFF + 1);
    }

    @Test
    void negativeZero_differsOnlyInBits() {
        Film film = RandomFilms.gray(2, 2, 0);
        Difference difference = Difference.of(film, RandomFilms.withGreen(film, 1, 0, -0f));

        assertThat(difference.values()).isEqualTo(1);
        assertThat(difference.maxAbsolute()).isZero();
        assertThat(difference.maxUlp()).isZero();
        assertThat(difference.x()).isEqualTo(1);
        assertThat(difference.linearPsnr()).isInfinite();
    }

    @Test
    void nanAndNumber_differByInfinity() {
        Film film = RandomFilms.gray(2, 2, 0);
        Difference difference = Difference.of(film, RandomFilms.withGreen(film, 1, 1, Float.NaN));

        assertThat(difference.maxAbsolute()).isInfinite();
        assertThat(difference.x()).isEqualTo(1);
        assertThat(difference.y()).isEqualTo(1);
    }

    @Test
    void differentSizes_areRejected() {
        assertThatThrownBy(() -> Difference.of(Film.black(2, 3), Film.black(3, 2)))
                .hasMessageContaining("2 × 3").hasMessageContaining("3 × 2");
    }

    @Provide
    Arbitrary<Film> films() {
        return RandomFilms.anyBits();
    }
}
