package lightning.format.jen;

import java.util.Locale;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Quote;
import lightning.format.jen.asset.JenLimits;

/** Tokenizer for scene files; comments run from {@code #} to the end of the line. */
final class Lexer {
    private final String text;
    private final ProblemList problems;
    private final TokenList tokens;
    private int position;

    private Lexer(String text, ProblemList problems) {
        this.text = text;
        this.problems = problems;
        this.tokens = new TokenList(text);
    }

    /** Returns all tokens of {@code text}; invalid characters are reported and skipped. */
    static TokenList tokens(String text, ProblemList problems) {
        return new Lexer(text, problems).tokenize();
    }

    private TokenList tokenize() {
        if (text.startsWith("\uFEFF")) {
            position = 1; // skip the byte order mark, which some editors write
        }
        while (position < text.length() && !problems.isFull()) {
            if (tokens.size() == JenLimits.TOKENS) {
                problems.add(position, "a scene file may have at most " + JenLimits.TOKENS + " words, numbers and braces");
                break;
            }
            char c = text.charAt(position);
            switch (c) {
                case ' ', '\t', '\r', '\n' -> position++;
                case '#' -> skipComment();
                case '{' -> tokens.add(TokenList.Kind.OPEN, position, ++position);
                case '}' -> tokens.add(TokenList.Kind.CLOSE, position, ++position);
                case '"' -> readString();
                default -> readWord(c);
            }
        }
        tokens.add(TokenList.Kind.END, text.length(), text.length());
        return tokens;
    }

    private void skipComment() {
        int end = text.indexOf('\n', position);
        position = end < 0 ? text.length() : end;
    }

    private void readString() {
        int start = position;
        int close = NameSyntax.closingQuote(text, start);
        if (close < 0) {
            problems.add(start, "a '\"' must be closed by another in the same line");
            int end = text.indexOf('\n', start);
            position = end < 0 ? text.length() : end;
            return;
        }
        checkEscapes(start + 1, close);
        position = close + 1;
        endToken(TokenList.Kind.STRING, start);
    }

    /** Reports a backslash in a string that is not followed by a quote or a backslash. */
    private void checkEscapes(int from, int to) {
        for (int i = text.indexOf('\\', from, to); i >= 0; i = text.indexOf('\\', i + 2, to)) {
            if (!NameSyntax.isEscapable(text.charAt(i + 1))) {
                problems.add(from - 1,
                        "a '\\' in quotes must stand before '\"' or another '\\', found " + describe(text.codePointAt(i + 1)));
                return;
            }
        }
    }

    private void readWord(char first) {
        int start = position;
        boolean isNumber = first >= '0' && first <= '9' || first == '-' || first == '+' || first == '.';
        while (position < text.length()) {
            int c = text.codePointAt(position);
            if (!NameSyntax.isWordPart(c) && !(isNumber && (c == '.' || c == '+'))) {
                break;
            }
            position += Character.charCount(c);
        }
        if (isNumber) {
            endToken(DecimalNumber.isNumber(text, start, position) ? TokenList.Kind.NUMBER : TokenList.Kind.BAD_NUMBER, start);
        } else if (position > start && NameSyntax.isWordStart(text.codePointAt(start))) {
            endToken(TokenList.Kind.WORD, start);
        } else {
            int c = text.codePointAt(start);
            position = Math.max(position, start + Character.charCount(c));
            problems.add(start, "expected a word, a number or a brace, found " + describe(c));
        }
    }

    /** Adds a token and checks that a delimiter follows it. */
    private void endToken(TokenList.Kind kind, int start) {
        if (position - start > JenLimits.TOKEN_LENGTH && text.codePointCount(start, position) > JenLimits.TOKEN_LENGTH) {
            problems.add(start, "a word, number or string may have at most " + JenLimits.TOKEN_LENGTH
                    + " characters, found " + text.codePointCount(start, position));
            return;
        }
        if (position < text.length() && "\t\n\r #{}".indexOf(text.charAt(position)) < 0) {
            problems.add(position, "expected a space, found " + describe(text.codePointAt(position)));
        }
        tokens.add(kind, start, position);
    }

    private static String describe(int c) {
        boolean visible = c > ' ' && c < 0x7F || Character.isLetterOrDigit(c);
        return visible ? Quote.of(Character.toString(c)) : String.format(Locale.ROOT, "U+%04X", c);
    }
}
