package lightning.render.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class IndirectErrorTest {
    private static final double EPSILON = 1e-12;

    @Test
    void errors_areRelativeToReference() {
        IndirectError error = IndirectError.of(new double[] {1.1, 2, 2.7}, new double[] {1, 2, 3}, new double[] {2, 3, 5});
        assertThat(error.mean()).isEqualTo((0.1 + 0 + 0.1) / 3, within(EPSILON));
        assertThat(error.median()).isEqualTo(0.1, within(EPSILON));
        assertThat(error.high()).isEqualTo(0.1, within(EPSILON));
        assertThat(error.bias()).isEqualTo(-0.2 / 6, within(EPSILON));
        assertThat(error.missing()).isEqualTo(0.4, within(EPSILON));
    }

    @Test
    void darkPixel_countsRelativeToTwentiethOfMean() {
        double[] exact = {0, 2};
        assertThat(IndirectError.of(new double[] {0.05, 2}, exact, exact).high()).isEqualTo(1, within(EPSILON));
    }

    @Test
    void blackScene_hasNoError() {
        double[] black = new double[4];
        assertThat(IndirectError.of(black, black, black)).isEqualTo(new IndirectError(0, 0, 0, 0, 0));
        assertThat(IndirectError.of(new double[] {0, 1, 0, 0}, black, black).high()).isEqualTo(1);
    }

    @Test
    void noPixel_isRejected() {
        assertThatThrownBy(() -> IndirectError.of(new double[0], new double[0], new double[0]))
                .isInstanceOf(IllegalArgumentException.class).hasMessageContaining("found none");
    }
}
