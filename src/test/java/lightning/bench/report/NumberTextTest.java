package lightning.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class NumberTextTest {

    @Test
    void numbers_haveThreeDigits() {
        assertThat(NumberText.threeDigits(0.12345)).isEqualTo("0.123");
        assertThat(NumberText.threeDigits(12.345)).isEqualTo("12.3");
        assertThat(NumberText.threeDigits(-123.45)).isEqualTo("−123");
        assertThat(NumberText.threeDigits(12345)).isEqualTo("12\u202f345");
    }

    @Test
    void ticks_areShort() {
        assertThat(NumberText.tick(0.1)).isEqualTo("0.1");
        assertThat(NumberText.tick(5 * 0.01)).isEqualTo("0.05");
        assertThat(NumberText.tick(200)).isEqualTo("200");
        assertThat(NumberText.tick(50_000)).isEqualTo("50\u202f000");
    }

    @Test
    void tinyErrors_usePowersOfTen() {
        assertThat(NumberText.error(3.14e-8)).isEqualTo("3.1·10⁻⁸");
        assertThat(NumberText.error(0.25)).isEqualTo("0.250");
        assertThat(NumberText.error(0)).isEqualTo("0");
    }

    @Test
    void smallShare_isNotNone() {
        assertThat(NumberText.share(0, 270_000)).isEqualTo("none");
        assertThat(NumberText.share(1, 270_000)).isEqualTo("< 0.1\u00a0%");
        assertThat(NumberText.share(1, 4)).isEqualTo("25.0\u00a0%");
    }

    @Test
    void missingNumber_isDash() {
        assertThat(NumberText.percent(Double.NaN)).isEqualTo("–");
        assertThat(NumberText.ms(Double.POSITIVE_INFINITY)).isEqualTo("∞");
        assertThat(NumberText.error(Double.NaN)).isEqualTo("–");
    }
}
