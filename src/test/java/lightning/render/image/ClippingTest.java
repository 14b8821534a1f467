package lightning.render.image;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class ClippingTest {
    /** White itself, one value above it in each channel, the largest float, and black. */
    private static final Film FILM =
            Film.ofScanlines(5, 1, new float[] {1, 1, 1, 0, 0, 1.5f, 0, Math.nextUp(1f), 0, Float.MAX_VALUE, 0, 0, 0, 0, 0});

    @Test
    void pixelsAboveWhite_areCountedOnce() {
        Clipping clipping = Clipping.of(FILM, ViewTransform.DEFAULT);
        assertThat(clipping.clippedPixels()).isEqualTo(3);
        assertThat(clipping.totalPixels()).isEqualTo(5);
        assertThat(clipping.brightest()).isEqualTo(Float.MAX_VALUE);
    }

    /** Two stops down, 1.5 is below white; one stop up, white itself is clipped. */
    @Test
    void exposure_changesClippedPixels() {
        assertThat(Clipping.of(FILM, new ViewTransform(-2)).clippedPixels()).isEqualTo(1);
        assertThat(Clipping.of(FILM, new ViewTransform(1)).clippedPixels()).isEqualTo(4);
        assertThat(Clipping.of(FILM, new ViewTransform(64)).brightest()).as("beyond a float").isCloseTo(0x1p64 * Float.MAX_VALUE,
                within(1e50));
    }

    @Test
    void blackFilm_hasNoClipping() {
        assertThat(Clipping.of(Film.black(3, 2), ViewTransform.DEFAULT)).isEqualTo(new Clipping(0, 6, 0));
    }
}
