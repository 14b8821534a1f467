package lightning.base.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.LongRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class DecimalNumberTest {
    @ParameterizedTest
    @CsvSource({"1, 1", "-0.5, -0.5", ".5, 0.5", "5., 5", "+3, 3", "1.5e-3, 0.0015", "1E2, 100", "0e0, 0", "007, 7", "1e-400, 0"})
    void decimalNumber_isParsed(String text, double value) {
        assertThat(DecimalNumber.parse(text)).hasValue(value);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "-", ".", "e1", "1e", "1e+", "1d", "1f", "0x1p3", "0x10", "NaN", "Infinity", "-Infinity", "1_0", "1,5",
        "1.2.3", " 1", "1 ", "١", "１", "--1", "1e1.5", "𝟏"})
    void otherText_isNotANumber(String text) {
        assertThat(DecimalNumber.parse(text)).isEmpty();
    }

    @Test
    void numberBeyondTheRange_isInfinite() {
        assertThat(DecimalNumber.parse("1e999")).hasValue(Double.POSITIVE_INFINITY);
        assertThat(DecimalNumber.parse("-1e999")).hasValue(Double.NEGATIVE_INFINITY);
    }

    @Property
    void anyDigits_parseToNearestDouble(@ForAll @LongRange(min = 0, max = 999_999_999_999_999_999L) long digits,
            @ForAll @IntRange(max = 24) int decimals) {
        String padded = "0".repeat(decimals) + digits;
        String text = padded.substring(0, padded.length() - decimals) + "." + padded.substring(padded.length() - decimals);
        assertThat(DecimalNumber.parse(text)).hasValue(new BigDecimal(text).doubleValue());
    }

    /** Tests the midpoint of two doubles, and its neighbors in the last decimal place. */
    @Property
    void digitsNearMidpoint_parseToNearestDouble(@ForAll @LongRange(min = 1L << 52, max = (1L << 53) - 1) long mantissa,
            @ForAll @IntRange(min = 1, max = 6) int up, @ForAll @IntRange(max = 6) int decimals,
            @ForAll @IntRange(min = -1, max = 1) int off) {
        String text = BigDecimal.valueOf((2 * mantissa + 1 << up - 1) + off, decimals).toPlainString();
        assertThat(DecimalNumber.parse(text)).hasValue(new BigDecimal(text).doubleValue());
    }

    @Property
    void anyDouble_roundTrips(@ForAll long bits) {
        double v = Double.longBitsToDouble(bits);
        if (Double.isFinite(v)) {
            String text = DecimalNumber.format(v);
            assertThat(DecimalNumber.parse(text)).hasValue(v);
            assertThat(text.length()).isLessThanOrEqualTo(Double.toString(v).length());
        }
    }
}
