package lightning.render.shading.layer;

import lightning.render.shading.TermKernel;
import lightning.render.trace.Tracer;

/** Bit sets of a tile's rows, one bit per row; the lowest bit of an {@code int} is its first row. */
public final class RowBits {
    /** Rows per word. */
    public static final int WIDTH = Tracer.ROWS_PER_WORD;
    private static final int ALL = (1 << WIDTH) - 1;

    private RowBits() {}

    /** Allocates a set for the rows of any tile. */
    public static int[] allocate() {
        return new int[words(TermKernel.MAX_ROWS)];
    }

    /** Returns the number of words for {@code rows} rows. */
    public static int words(int rows) {
        return (rows + WIDTH - 1) / WIDTH;
    }

    /** Returns the bits of word {@code b} that stand for one of {@code rows} rows. */
    public static int validBits(int b, int rows) {
        int rest = rows - b * WIDTH;
        return rest >= WIDTH ? ALL : (1 << rest) - 1;
    }

    /** Returns the bits of word {@code b} that stand for rows {@code from … to − 1}. */
    public static int rangeBits(int b, int from, int to) {
        return validBits(b, to) & -1 << Math.max(0, from - b * WIDTH);
    }

    /** Returns the number of {@code rows} rows that are in the set. */
    public static int count(int[] bits, int rows) {
        int count = 0;
        for (int b = 0; b < words(rows); b++) {
            count += Integer.bitCount(bits[b]);
        }
        return count;
    }

    /** Returns the number of rows {@code from … to − 1} that are in the set. */
    public static int count(int[] bits, int from, int to) {
        int count = 0;
        for (int b = from / WIDTH; b * WIDTH < to; b++) {
            count += Integer.bitCount(bits[b] & rangeBits(b, from, to));
        }
        return count;
    }

    /** Receives a run of rows {@code from … to − 1}, whole words. */
    public interface Run {
        void accept(int from, int to);
    }

    /** Visits the longest runs of words that each have a row of the set, among {@code rows} rows. */
    public static void forEachRun(int[] rowSet, int rows, Run run) {
        int words = words(rows);
        int first = 0;
        while (first < words) {
            int end = firstEmptyWord(rowSet, first, words);
            if (end > first) {
                run.accept(first * WIDTH, end * WIDTH);
            }
            first = end + 1;
        }
    }

    /** Returns the first word from {@code b} on without a row of the set; {@code words} if all have one. */
    private static int firstEmptyWord(int[] bits, int b, int words) {
        int end = b;
        while (end < words && bits[end] != 0) {
            end++;
        }
        return end;
    }

    /** Adds rows {@code from … to − 1} to the set. */
    public static void add(int[] bits, int from, int to) {
        for (int b = from / WIDTH; b * WIDTH < to; b++) {
            bits[b] |= rangeBits(b, from, to);
        }
    }

    /** Removes rows {@code from … to − 1} from the set. */
    static void remove(int[] bits, int from, int to) {
        for (int b = from / WIDTH; b * WIDTH < to; b++) {
            bits[b] &= ~rangeBits(b, from, to);
        }
    }

    public static boolean contains(int[] bits, int row) {
        return (bits[row / WIDTH] >>> row % WIDTH & 1) != 0;
    }

    public static void add(int[] bits, int row) {
        bits[row / WIDTH] |= 1 << row % WIDTH;
    }

    /** Adds the rows in a state, see {@link LightRows}, to the set. */
    static void selectState(byte[] states, int rows, int state, int[] bits) {
        selectStates(states, rows, 1 << state, bits);
    }

    /**
     * Adds the rows in any of several states to the set.
     *
     * @param stateMask one bit for each state
     */
    static void selectStates(byte[] states, int rows, int stateMask, int[] bits) {
        for (int b = 0; b < words(rows); b++) {
            int word = 0;
            int end = Math.min(WIDTH, rows - b * WIDTH);
            for (int i = 0; i < end; i++) {
                word |= (stateMask >>> (states[b * WIDTH + i] & LightRows.STATE_MASK) & 1) << i;
            }
            bits[b] = word;
        }
    }

    /**
     * Transposes a square of bits: exchanges bit c of word r and bit r of word c, {@code int[WIDTH]}. Swaps halves of the square,
     * then halves of these (Warren, Hacker's Delight, §7-3).
     */
    static void transpose(int[] square) {
        int low = ALL;
        for (int half = WIDTH / 2; half > 0; half /= 2) {
            low ^= low << half & ALL;
            for (int r = 0; r < WIDTH; r = r + half + 1 & ~half) {
                int other = (square[r] >>> half ^ square[r + half]) & low;
                square[r + half] ^= other;
                square[r] ^= other << half;
            }
        }
    }
}
