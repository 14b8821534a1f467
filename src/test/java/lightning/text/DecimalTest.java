package lightning.text;

import static org.assertj.core.api.Assertions.assertThat;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class DecimalTest {
    @ParameterizedTest
    @CsvSource({"1, 1", "-0.5, -0.5", ".5, 0.5", "5., 5", "+3, 3", "1.5e-3, 0.0015", "1E2, 100", "0e0, 0", "007, 7", "1e-400, 0"})
    void decimalNumber_isRead(String text, double value) {
        assertThat(Decimal.read(text)).hasValue(value);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "-", ".", "e1", "1e", "1e+", "1d", "1f", "0x1p3", "0x10", "NaN", "Infinity", "-Infinity", "1_0", "1,5",
        "1.2.3", " 1", "1 ", "١", "１", "--1", "1e1.5", "𝟏"})
    void anythingElse_isNoNumber(String text) {
        assertThat(Decimal.read(text)).isEmpty();
    }

    @Test
    void numberBeyondTheRange_isInfinite() {
        assertThat(Decimal.read("1e999")).hasValue(Double.POSITIVE_INFINITY);
        assertThat(Decimal.read("-1e999")).hasValue(Double.NEGATIVE_INFINITY);
    }

    @Property
    void anyDouble_isWrittenWithoutLoss(@ForAll long bits) {
        double v = Double.longBitsToDouble(bits);
        if (Double.isFinite(v)) {
            String text = Decimal.text(v);
            assertThat(Decimal.read(text)).hasValue(v);
            assertThat(text.length()).isLessThanOrEqualTo(Double.toString(v).length());
        }
    }
}
