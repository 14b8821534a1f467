package lightning.format.jen;

import java.util.Locale;
import lightning.base.text.Decimal;
import lightning.base.text.Quote;

/** Cuts the text of a scene file into tokens; comments run from {@code #} to the end of the line. */
final class Lexer {
    private final String text;
    private final Problems problems;
    private final Tokens tokens;
    private int at;

    private Lexer(String text, Problems problems) {
        this.text = text;
        this.problems = problems;
        this.tokens = new Tokens(text);
    }

    /** All tokens of {@code text}; what is none is reported and left out. */
    static Tokens tokens(String text, Problems problems) {
        return new Lexer(text, problems).run();
    }

    private Tokens run() {
        if (text.startsWith("\uFEFF")) {
            at = 1; // a byte order mark, which some editors write
        }
        while (at < text.length() && !problems.isFull()) {
            if (tokens.size() == JenLimits.TOKENS) {
                problems.add(at, "a scene file may have at most " + JenLimits.TOKENS + " words, numbers and braces");
                break;
            }
            char c = text.charAt(at);
            switch (c) {
                case ' ', '\t', '\r', '\n' -> at++;
                case '#' -> skipComment();
                case '{' -> tokens.add(Tokens.Kind.OPEN, at, ++at);
                case '}' -> tokens.add(Tokens.Kind.CLOSE, at, ++at);
                case '"' -> string();
                default -> word(c);
            }
        }
        tokens.add(Tokens.Kind.END, text.length(), text.length());
        return tokens;
    }

    private void skipComment() {
        int end = text.indexOf('\n', at);
        at = end < 0 ? text.length() : end;
    }

    private void string() {
        int start = at;
        int close = NameText.closing(text, start);
        if (close < 0) {
            problems.add(start, "a '\"' must be closed by another in the same line");
            int end = text.indexOf('\n', start);
            at = end < 0 ? text.length() : end;
            return;
        }
        escapes(start + 1, close);
        at = close + 1;
        end(Tokens.Kind.STRING, start);
    }

    /** Reports a string with a backslash that stands before anything but a quote or a backslash. */
    private void escapes(int from, int to) {
        for (int i = text.indexOf('\\', from, to); i >= 0; i = text.indexOf('\\', i + 2, to)) {
            if (!NameText.isEscaped(text.charAt(i + 1))) {
                problems.add(from - 1, "a '\\' in quotes must stand before '\"' or another '\\', found " + shown(text.codePointAt(i + 1)));
                return;
            }
        }
    }

    private void word(char first) {
        int start = at;
        boolean number = first >= '0' && first <= '9' || first == '-' || first == '+' || first == '.';
        while (at < text.length()) {
            int c = text.codePointAt(at);
            if (!NameText.isWordPart(c) && !(number && (c == '.' || c == '+'))) {
                break;
            }
            at += Character.charCount(c);
        }
        if (number) {
            end(Decimal.is(text, start, at) ? Tokens.Kind.NUMBER : Tokens.Kind.BAD_NUMBER, start);
        } else if (at > start && NameText.isWordStart(text.codePointAt(start))) {
            end(Tokens.Kind.WORD, start);
        } else {
            int c = text.codePointAt(start);
            at = Math.max(at, start + Character.charCount(c));
            problems.add(start, "expected a word, a number or a brace, found " + shown(c));
        }
    }

    /** Adds a token, which must be followed by something that ends it. */
    private void end(Tokens.Kind kind, int start) {
        if (at - start > JenLimits.TOKEN_LENGTH && text.codePointCount(start, at) > JenLimits.TOKEN_LENGTH) {
            problems.add(start, "a word, number or string may have at most " + JenLimits.TOKEN_LENGTH
                    + " characters, found " + text.codePointCount(start, at));
            return;
        }
        if (at < text.length() && "\t\n\r #{}".indexOf(text.charAt(at)) < 0) {
            problems.add(at, "expected a space, found " + shown(text.codePointAt(at)));
        }
        tokens.add(kind, start, at);
    }

    private static String shown(int c) {
        boolean visible = c > ' ' && c < 0x7F || Character.isLetterOrDigit(c);
        return visible ? Quote.of(Character.toString(c)) : String.format(Locale.ROOT, "U+%04X", c);
    }
}
