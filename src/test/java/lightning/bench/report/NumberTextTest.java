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
    void missingNumber_isDash() {
        assertThat(NumberText.percent(Double.NaN)).isEqualTo("–");
        assertThat(NumberText.threeDigits(Double.POSITIVE_INFINITY)).isEqualTo("∞");
    }
}
