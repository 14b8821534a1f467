package lightning.base.math;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class RgbTest {
    private static final Rgb COLOR = new Rgb(0.5, 0.25, 2);

    @Test
    void times_scalesEachChannel() {
        assertThat(COLOR.times(4)).isEqualTo(new Rgb(2, 1, 8));
        assertThat(Rgb.gray(3)).isEqualTo(new Rgb(3, 3, 3));
    }

    @Test
    void minAndMaxChannel_areFound() {
        for (Rgb c : new Rgb[] {COLOR, new Rgb(2, 0.5, 0.25), new Rgb(0.25, 2, 0.5)}) {
            assertThat(c.min()).isEqualTo(0.25);
            assertThat(c.max()).isEqualTo(2);
        }
        assertThat(new Rgb(1, Double.NaN, 2).max()).isNaN();
        assertThat(new Rgb(1, 2, Double.NaN).min()).isNaN();
    }

    @Test
    void black_hasZeroChannels() {
        assertThat(new Rgb(0, -0.0, 0).isBlack()).isTrue();
        assertThat(new Rgb(1e-300, 0, 0).isBlack()).isFalse();
        assertThat(new Rgb(0, 1e-300, 0).isBlack()).isFalse();
        assertThat(new Rgb(0, 0, 1e-300).isBlack()).isFalse();
    }
}
