package lightning.bench.report;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class NumbersTest {

    @Test
    void numbers_haveThreeDigits() {
        assertThat(Numbers.plain(0.12345)).isEqualTo("0.123");
        assertThat(Numbers.plain(12.345)).isEqualTo("12.3");
        assertThat(Numbers.plain(-123.45)).isEqualTo("−123");
        assertThat(Numbers.plain(12345)).isEqualTo("12\u202f345");
    }

    @Test
    void ticks_areAsShortAsTheyCanBe() {
        assertThat(Numbers.tick(0.1)).isEqualTo("0.1");
        assertThat(Numbers.tick(5 * 0.01)).isEqualTo("0.05");
        assertThat(Numbers.tick(200)).isEqualTo("200");
        assertThat(Numbers.tick(50_000)).isEqualTo("50\u202f000");
    }

    @Test
    void tinyErrors_areTimesAPowerOfTen() {
        assertThat(Numbers.error(3.14e-8)).isEqualTo("3.1·10⁻⁸");
        assertThat(Numbers.error(0.25)).isEqualTo("0.250");
        assertThat(Numbers.error(0)).isEqualTo("0");
    }

    @Test
    void aFewOfMany_areNotNone() {
        assertThat(Numbers.share(0, 270_000)).isEqualTo("none");
        assertThat(Numbers.share(1, 270_000)).isEqualTo("< 0.1\u00a0%");
        assertThat(Numbers.share(1, 4)).isEqualTo("25.0\u00a0%");
    }

    @Test
    void whatDoesNotExist_isADash() {
        assertThat(Numbers.percent(Double.NaN)).isEqualTo("–");
        assertThat(Numbers.ms(Double.POSITIVE_INFINITY)).isEqualTo("∞");
        assertThat(Numbers.error(Double.NaN)).isEqualTo("–");
    }
}
