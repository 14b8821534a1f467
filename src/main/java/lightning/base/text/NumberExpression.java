package lightning.base.text;

import java.math.BigDecimal;
import java.util.Locale;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;

/**
 * Arithmetic expression typed into a number field: {@code 0.3*2}, {@code (1+2)/3}, {@code +10%}, {@code *2}, {@code += 0.5}, {@code 45
 * deg}.
 *
 * <pre>
 * text    := [ "+=" | "-=" | "*" | "/" ] sum [ unit ]
 * sum     := product { ("+" | "-") product }
 * product := factor { ("*" | "/") factor }
 * factor  := ("+" | "-") factor | ( number | "(" sum ")" ) [ "%" ]
 * </pre>
 *
 * <p>A text that begins with one of the four operators, or with a percentage, applies to the current value: {@code *2} doubles it, {@code
 * +10%} adds a tenth, {@code 50%} halves it. An added percentage refers to the value before it, as on a pocket calculator: {@code 200+10%}
 * is 220; elsewhere it means hundredths. The computation is exact and rounded once, to the nearest double.
 */
public final class NumberExpression {
    private static final int MAX_LENGTH = 200;
    private static final int MAX_EXPONENT = 400;

    private final String text;
    private final Fraction current;
    private int position;
    private int depth;

    /** Result of an evaluation: a value or an error. */
    public sealed interface Result {}

    /** @param value infinite if beyond the range of a double */
    public record Value(double value) implements Result {}

    /** @param reason a clause without a full stop, shown after the field's name */
    public record Invalid(String reason) implements Result {}

    /** Syntax error in a text. */
    private static final class SyntaxException extends RuntimeException {
        private static final long serialVersionUID = 1;

        SyntaxException(String reason) {
            super(reason, null, false, false);
        }
    }

    private NumberExpression(String text, double current) {
        this.text = text;
        this.current = Double.isFinite(current) ? Fraction.of(BigDecimal.valueOf(current)) : Fraction.ZERO;
    }

    /**
     * Evaluates a text.
     *
     * @param current the field's current value; if it is not finite, 0 is used
     */
    public static Result evaluate(String text, double current, NumberUnit measure) {
        String plain = text.strip().replace('−', '-').replace('×', '*').replace('·', '*').replace('÷', '/').replace('⁄', '/');
        OptionalDouble number = DecimalNumber.parse(plain);
        if (number.isPresent()) {
            return new Value(number.getAsDouble());
        }
        if (plain.length() > MAX_LENGTH) {
            return new Invalid("must be at most " + MAX_LENGTH + " characters long, was " + plain.length());
        }
        if (plain.chars().noneMatch(c -> c >= '0' && c <= '9')) {
            return new Invalid("must be a number, was " + Quote.of(text.strip()));
        }
        try {
            return new Value(new NumberExpression(plain, current).parseAll(measure, current));
        } catch (SyntaxException m) {
            return new Invalid("must be a number or an expression such as 0.3*2: " + m.getMessage());
        }
    }

    private double parseAll(NumberUnit measure, double currentValue) {
        Fraction number = parseRelative();
        skipBlanks();
        if (position == text.length()) {
            return number.toDouble();
        }
        String suffix = text.substring(position).strip().toLowerCase(Locale.ROOT);
        if (!measure.words().contains(suffix)) {
            throw syntaxError(Character.isLetter(text.charAt(position)) || text.charAt(position) == '°'
                    ? "the unit " + String.join(", ", measure.words()) : "+, -, *, / or the end");
        }
        return measure.convert(suffix, number, currentValue);
    }

    private Fraction parseRelative() {
        if (accept("+=")) {
            return current.plus(parseAmount());
        }
        if (accept("-=")) {
            return current.minus(parseAmount());
        }
        skipBlanks();
        return position < text.length() && (text.charAt(position) == '*' || text.charAt(position) == '/')
                ? continueSum(continueProduct(current)) : parseSum();
    }

    /** Parses the amount added to the current value. */
    private Fraction parseAmount() {
        Fraction share = parsePercentage();
        return share == null ? parseSum() : current.times(share);
    }

    private Fraction parseSum() {
        int start = position;
        if (depth == 0 && start == 0) {
            // A leading percentage refers to the current value.
            boolean minus = accept("-");
            boolean plus = !minus && accept("+");
            Fraction first = parsePercentage();
            if (first != null) {
                Fraction part = current.times(first);
                return continueSum(minus ? current.minus(part) : plus ? current.plus(part) : part);
            }
            position = start;
        }
        return continueSum(parseProduct());
    }

    private Fraction continueSum(Fraction left) {
        Fraction sum = left;
        while (true) {
            boolean plus = accept("+");
            if (!plus && !accept("-")) {
                return sum;
            }
            Fraction share = parsePercentage();
            Fraction next = share == null ? parseProduct() : sum.times(share);
            sum = plus ? sum.plus(next) : sum.minus(next);
        }
    }

    /** Parses a percentage that is not part of a product, as a fraction. Returns null without reading if there is none. */
    private @Nullable Fraction parsePercentage() {
        int start = position;
        skipBlanks();
        int from = position;
        if (skipNumber() && accept("%")) {
            int end = position;
            skipBlanks();
            if (position == text.length() || text.charAt(position) != '*' && text.charAt(position) != '/') {
                Fraction share = parseNumber(from, text.lastIndexOf('%', end - 1)).divide(Fraction.HUNDRED);
                position = end;
                return share;
            }
        }
        position = start;
        return null;
    }

    private Fraction parseProduct() {
        return continueProduct(parseFactor());
    }

    private Fraction continueProduct(Fraction left) {
        Fraction product = left;
        while (true) {
            if (accept("*")) {
                product = product.times(parseFactor());
            } else if (accept("/")) {
                Fraction divisor = parseFactor();
                if (divisor.isZero()) {
                    throw new SyntaxException("division by zero in " + Quote.of(text));
                }
                product = product.divide(divisor);
            } else {
                return product;
            }
        }
    }

    private Fraction parseFactor() {
        if (accept("-")) {
            return Fraction.ZERO.minus(parseFactor());
        }
        if (accept("+")) {
            return parseFactor();
        }
        Fraction value;
        if (accept("(")) {
            depth++;
            value = parseSum();
            depth--;
            if (!accept(")")) {
                throw syntaxError(")");
            }
        } else {
            skipBlanks();
            int from = position;
            if (!skipNumber()) {
                throw syntaxError("a number");
            }
            value = parseNumber(from, position);
        }
        return accept("%") ? value.divide(Fraction.HUNDRED) : value;
    }

    /** Skips a number without a sign, if there is one. */
    private boolean skipNumber() {
        int longest = position;
        for (int end = position + 1; end <= text.length(); end++) {
            if (position < text.length() && text.charAt(position) != '+' && text.charAt(position) != '-'
                    && DecimalNumber.isNumber(text, position, end)) {
                longest = end;
            }
        }
        boolean found = longest > position;
        position = longest;
        return found;
    }

    private Fraction parseNumber(int from, int to) {
        BigDecimal value;
        try {
            value = new BigDecimal(text.substring(from, to).strip());
        } catch (NumberFormatException e) {
            throw new SyntaxException(Quote.of(text.substring(from, to)) + " is too large or too small");
        }
        if (value.signum() != 0 && Math.abs((long) value.precision() - value.scale()) > MAX_EXPONENT) {
            throw new SyntaxException(Quote.of(text.substring(from, to).strip()) + " is too large or too small");
        }
        return value.signum() == 0 ? Fraction.ZERO : Fraction.of(value);
    }

    private boolean accept(String sign) {
        skipBlanks();
        if (text.startsWith(sign, position)) {
            position += sign.length();
            return true;
        }
        return false;
    }

    private void skipBlanks() {
        while (position < text.length() && Character.isWhitespace(text.charAt(position))) {
            position++;
        }
    }

    private SyntaxException syntaxError(String expectation) {
        skipBlanks();
        String before = text.substring(0, position).strip();
        String found = position == text.length() ? "the end" : Quote.of(text.substring(position));
        String hint = position < text.length() && text.charAt(position) == ',' ? "; use a decimal point" : "";
        return new SyntaxException(
                "expected " + expectation + (before.isEmpty() ? "" : " after " + Quote.of(before)) + ", found " + found + hint);
    }
}
