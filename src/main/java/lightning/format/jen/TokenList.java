package lightning.format.jen;

import java.util.Arrays;
import lightning.base.text.DecimalNumber;
import lightning.base.text.Quote;

/**
 * The words of a scene file with their places, as columns: token {@code i} is the characters from
 * {@code start(i)} to {@code end(i)}. After the last one comes an {@link Kind#END} at the end of the text.
 */
final class TokenList {
    enum Kind {
        /** A keyword, property name or name. */
        WORD,
        NUMBER,
        /** Begins like a number and is none. */
        BAD_NUMBER,
        /** In quotes. */
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
    /** Words met before, each where its hash says: most words of a file are a few keywords, which are asked for again and again. */
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

    /** The kind of token {@code i}; behind the last one there are only ends. */
    Kind kind(int i) {
        return i < size ? KINDS[kinds[i]] : Kind.END;
    }

    /** Whether token {@code i} can be a name. */
    boolean isName(int i) {
        return kind(i) == Kind.WORD || kind(i) == Kind.STRING;
    }

    int start(int i) {
        return starts[Math.min(i, size - 1)];
    }

    int end(int i) {
        return ends[Math.min(i, size - 1)];
    }

    /** The characters of token {@code i}, a string's without its quotes and escapes. */
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

    /** Token {@code i}, which is a number: the nearest double to it, or infinite. */
    double number(int i) {
        return DecimalNumber.parseRange(text, start(i), end(i));
    }

    /** Token {@code i} as a message quotes it. */
    String describe(int i) {
        if (kind(i) == Kind.END) {
            return "the end of the file";
        }
        return Quote.of(text.substring(start(i), end(i)));
    }
}
