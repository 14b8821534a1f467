package lightning.bench.accuracy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import lightning.render.image.Film;
import org.junit.jupiter.api.Test;

class DisplayErrorTest {
    private static Film film(float... rgb) {
        return Film.ofScanlines(rgb.length / 3, 1, rgb);
    }

    @Test
    void equalImages_haveNoError() {
        assertThat(DisplayError.of(film(0, 0.5f, 2), film(0, 0.5f, 2))).isZero();
    }

    @Test
    void error_isRootMeanSquareOfSquareRoots() {
        // The square roots differ by 0.5 in one value of six.
        assertThat(DisplayError.of(film(0.25f, 0, 0, 0, 0, 0), film(1, 0, 0, 0, 0, 0))).isCloseTo(0.5 / Math.sqrt(6), within(1e-7));
    }

    @Test
    void valuesAboveWhite_areWhite() {
        assertThat(DisplayError.of(film(1, 3, -1), film(7, 1, 0))).isZero();
    }

    @Test
    void otherSize_isRejected() {
        assertThatThrownBy(() -> DisplayError.of(film(1, 1, 1), film(1, 1, 1, 1, 1, 1))).isInstanceOf(IllegalArgumentException.class)
                .hasMessage("expected images of one size, found 1x1 and 2x1");
    }
}
