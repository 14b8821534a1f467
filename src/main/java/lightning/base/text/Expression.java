package lightning.base.text;

import java.math.BigDecimal;
import java.util.Locale;
import java.util.OptionalDouble;

/**
 * A number as people type it into a field: {@code 0.3*2}, {@code (1+2)/3}, {@code +10%}, {@code *2}, {@code += 0.5}, {@code 45 deg}.
 *
 * <pre>
 * text    := [ "+=" | "-=" | "*" | "/" ] sum [ unit ]
 * sum     := product { ("+" | "-") product }
 * product := factor { ("*" | "/") factor }
 * factor  := ("+" | "-") factor | ( number | "(" sum ")" ) [ "%" ]
 * </pre>
 *
 * <p>What begins with one of the four signs, and a percentage that stands first, start from the value that is there: {@code *2} is twice it,
 * {@code +10%} a tenth more, {@code 50%} half. A percentage that is added is one of what stands before it, as on a pocket calculator:
 * {@code 200+10%} is 220; elsewhere it is a hundredth. All is reckoned exactly and rounded once, to the nearest double.
 */
public final class Expression {
    private static final int LONGEST = 200;
    private static final int MOST_EXPONENT = 400;

    private final String text;
    private final Fraction current;
    private int at;
    private int depth;

    /** What came of a text: its value, or why it has none. */
    public sealed interface Read {}

    /** @param value may be infinite: what is beyond a double */
    public record Value(double value) implements Read {}

    /** @param reason a clause without a full stop, to stand behind the field's name */
    public record Wrong(String reason) implements Read {}

    /** What is wrong with a text. */
    private static final class Mistake extends RuntimeException {
        private static final long serialVersionUID = 1;

        Mistake(String reason) {
            super(reason, null, false, false);
        }
    }

    private Expression(String text, double current) {
        this.text = text;
        this.current = Double.isFinite(current) ? Fraction.of(BigDecimal.valueOf(current)) : Fraction.ZERO;
    }

    /**
     * Reads a text.
     *
     * @param current the value that stands there now; not finite where there is none, which counts as 0
     */
    public static Read read(String text, double current, Measure measure) {
        String plain = text.strip().replace('−', '-').replace('×', '*').replace('·', '*').replace('÷', '/').replace('⁄', '/');
        OptionalDouble number = Decimal.read(plain);
        if (number.isPresent()) {
            return new Value(number.getAsDouble());
        }
        if (plain.length() > LONGEST) {
            return new Wrong("must be at most " + LONGEST + " characters long, was " + plain.length());
        }
        if (plain.chars().noneMatch(c -> c >= '0' && c <= '9')) {
            return new Wrong("must be a number, was " + Quote.of(text.strip()));
        }
        try {
            return new Value(new Expression(plain, current).whole(measure, current));
        } catch (Mistake m) {
            return new Wrong("must be a number or a sum as 0.3*2: " + m.getMessage());
        }
    }

    private double whole(Measure measure, double now) {
        Fraction number = relative();
        skip();
        if (at == text.length()) {
            return number.toDouble();
        }
        String rest = text.substring(at).strip().toLowerCase(Locale.ROOT);
        if (!measure.words().contains(rest)) {
            throw expected(Character.isLetter(text.charAt(at)) || text.charAt(at) == '°'
                    ? "the unit " + String.join(", ", measure.words()) : "+, -, *, / or the end");
        }
        return measure.value(rest, number, now);
    }

    private Fraction relative() {
        if (take("+=")) {
            return current.plus(amount());
        }
        if (take("-=")) {
            return current.minus(amount());
        }
        skip();
        return at < text.length() && (text.charAt(at) == '*' || text.charAt(at) == '/') ? sums(products(current)) : sum();
    }

    /** What is added to the value that is there. */
    private Fraction amount() {
        Fraction share = percentage();
        return share == null ? sum() : current.times(share);
    }

    private Fraction sum() {
        int start = at;
        if (depth == 0 && start == 0) {
            // A percentage that stands first is one of what is there.
            boolean minus = take("-");
            boolean plus = !minus && take("+");
            Fraction first = percentage();
            if (first != null) {
                Fraction part = current.times(first);
                return sums(minus ? current.minus(part) : plus ? current.plus(part) : part);
            }
            at = start;
        }
        return sums(product());
    }

    private Fraction sums(Fraction before) {
        Fraction sum = before;
        while (true) {
            boolean plus = take("+");
            if (!plus && !take("-")) {
                return sum;
            }
            Fraction share = percentage();
            Fraction next = share == null ? product() : sum.times(share);
            sum = plus ? sum.plus(next) : sum.minus(next);
        }
    }

    /** A percentage that nothing multiplies, as a share; null where there is none, and nothing is read. */
    private Fraction percentage() {
        int start = at;
        skip();
        int from = at;
        if (digits() && take("%")) {
            int end = at;
            skip();
            if (at == text.length() || text.charAt(at) != '*' && text.charAt(at) != '/') {
                Fraction share = number(from, text.lastIndexOf('%', end - 1)).by(Fraction.HUNDRED);
                at = end;
                return share;
            }
        }
        at = start;
        return null;
    }

    private Fraction product() {
        return products(factor());
    }

    private Fraction products(Fraction before) {
        Fraction product = before;
        while (true) {
            if (take("*")) {
                product = product.times(factor());
            } else if (take("/")) {
                Fraction divisor = factor();
                if (divisor.isZero()) {
                    throw new Mistake("division by zero in " + Quote.of(text));
                }
                product = product.by(divisor);
            } else {
                return product;
            }
        }
    }

    private Fraction factor() {
        if (take("-")) {
            return Fraction.ZERO.minus(factor());
        }
        if (take("+")) {
            return factor();
        }
        Fraction value;
        if (take("(")) {
            depth++;
            value = sum();
            depth--;
            if (!take(")")) {
                throw expected(")");
            }
        } else {
            skip();
            int from = at;
            if (!digits()) {
                throw expected("a number");
            }
            value = number(from, at);
        }
        return take("%") ? value.by(Fraction.HUNDRED) : value;
    }

    /** Goes over a number without a sign, if there is one. */
    private boolean digits() {
        int longest = at;
        for (int end = at + 1; end <= text.length(); end++) {
            if (at < text.length() && text.charAt(at) != '+' && text.charAt(at) != '-' && Decimal.is(text, at, end)) {
                longest = end;
            }
        }
        boolean any = longest > at;
        at = longest;
        return any;
    }

    private Fraction number(int from, int to) {
        BigDecimal value;
        try {
            value = new BigDecimal(text.substring(from, to).strip());
        } catch (NumberFormatException e) {
            throw new Mistake(Quote.of(text.substring(from, to)) + " is too large or too small");
        }
        if (value.signum() != 0 && Math.abs((long) value.precision() - value.scale()) > MOST_EXPONENT) {
            throw new Mistake(Quote.of(text.substring(from, to).strip()) + " is too large or too small");
        }
        return value.signum() == 0 ? Fraction.ZERO : Fraction.of(value);
    }

    private boolean take(String sign) {
        skip();
        if (text.startsWith(sign, at)) {
            at += sign.length();
            return true;
        }
        return false;
    }

    private void skip() {
        while (at < text.length() && Character.isWhitespace(text.charAt(at))) {
            at++;
        }
    }

    private Mistake expected(String what) {
        skip();
        String before = text.substring(0, at).strip();
        String found = at == text.length() ? "nothing" : Quote.of(text.substring(at));
        String hint = at < text.length() && text.charAt(at) == ',' ? "; decimals are written with a point" : "";
        return new Mistake("expected " + what + (before.isEmpty() ? "" : " after " + Quote.of(before)) + ", found " + found + hint);
    }
}
