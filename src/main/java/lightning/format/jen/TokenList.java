package lightning.format.jen;

import java.util.Arrays;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Quote;

/**
 * Tokens of a scene file as columns: token {@code i} spans the characters from {@code start(i)} to {@code end(i)}. The last
 * token is followed by an {@link Kind#END} at the end of the text.
 */
final class TokenList {
    enum Kind {
        /** Keyword, property name or name. */
        WORD,
        NUMBER,
        /** Invalid number. */
        BAD_NUMBER,
        /** String in quotes. */
        STRING,
        OPEN,
        CLOSE,
        END
    }

    private static final Kind[] KINDS = Kind.values();

    private final String text;
    private int[] starts = new int[64];
    private int[] ends = new int[64];
    private byte[] kinds = new byte[64];
    private int size;
    /** Interning table for words by hash: most words are a few keywords that are requested repeatedly. */
    private final String[] words = new String[256];

    TokenList(String text) {
        this.text = text;
    }

    void add(Kind kind, int start, int end) {
        if (size == starts.length) {
            starts = Arrays.copyOf(starts, 2 * size);
            ends = Arrays.copyOf(ends, 2 * size);
            kinds = Arrays.copyOf(kinds, 2 * size);
        }
        starts[size] = start;
        ends[size] = end;
        kinds[size++] = (byte) kind.ordinal();
    }

    int size() {
        return size;
    }

    /** Returns the kind of token {@code i}; END after the last one. */
    Kind kind(int i) {
        return i < size ? KINDS[kinds[i]] : Kind.END;
    }

    /** Returns whether token {@code i} can be a name. */
    boolean isName(int i) {
        return kind(i) == Kind.WORD || kind(i) == Kind.STRING;
    }

    int start(int i) {
        return starts[Math.min(i, size - 1)];
    }

    int end(int i) {
        return ends[Math.min(i, size - 1)];
    }

    /** Returns the characters of token {@code i}, without quotes and escapes for a string. */
    String text(int i) {
        return switch (kind(i)) {
            case STRING -> NameSyntax.unescape(text.substring(start(i) + 1, end(i) - 1));
            case WORD -> word(start(i), end(i));
            case NUMBER, BAD_NUMBER, OPEN, CLOSE, END -> text.substring(start(i), end(i));
        };
    }

    private String word(int from, int to) {
        int hash = 0;
        for (int i = from; i < to; i++) {
            hash = 31 * hash + text.charAt(i);
        }
        int slot = hash & words.length - 1;
        String cached = words[slot];
        if (cached == null || cached.length() != to - from || !text.startsWith(cached, from)) {
            cached = text.substring(from, to);
            words[slot] = cached;
        }
        return cached;
    }

    /** Returns the nearest double to the number token {@code i}, possibly infinite. */
    double number(int i) {
        return DecimalNumber.parseRange(text, start(i), end(i));
    }

    /** Returns the token after the braces that open at token {@code i}, or after the token itself if it opens none. */
    int skipBraces(int i) {
        int depth = 0;
        int token = i;
        do {
            if (kind(token) == Kind.END) {
                return token;
            }
            depth += kind(token) == Kind.OPEN ? 1 : kind(token) == Kind.CLOSE ? -1 : 0;
            token++;
        } while (depth > 0);
        return token;
    }

    /** Returns the next word, brace or end from token {@code i} on. */
    int skipLiterals(int i) {
        int token = i;
        while (kind(token) == Kind.NUMBER || kind(token) == Kind.BAD_NUMBER || kind(token) == Kind.STRING) {
            token++;
        }
        return token;
    }

    /** Returns token {@code i} as quoted in messages. */
    String describe(int i) {
        if (kind(i) == Kind.END) {
            return "the end of the file";
        }
        return Quote.of(text.substring(start(i), end(i)));
    }
}
