package lightning.render.shading;

import lightning.render.trace.Tracer;

/**
 * Sets of rows of a tile: one bit for each row, the lowest of an {@code int} for its first row.
 */
public final class RowBits {
    /** Rows in a word. */
    public static final int WIDTH = Tracer.ROWS_PER_WORD;
    private static final int ALL = (1 << WIDTH) - 1;

    private RowBits() {}

    /** Room for the rows of any tile. */
    static int[] allocate() {
        return new int[words(TermKernel.MAX_ROWS)];
    }

    /** How many words hold {@code rows} rows. */
    public static int words(int rows) {
        return (rows + WIDTH - 1) / WIDTH;
    }

    /** The bits of word {@code b} that stand for one of {@code rows} rows. */
    public static int validBits(int b, int rows) {
        int rest = rows - b * WIDTH;
        return rest >= WIDTH ? ALL : (1 << rest) - 1;
    }

    /** The bits of word {@code b} that stand for rows {@code from … to − 1}. */
    public static int rangeBits(int b, int from, int to) {
        return validBits(b, to) & -1 << Math.max(0, from - b * WIDTH);
    }

    /** How many of {@code rows} rows are in the set. */
    static int count(int[] bits, int rows) {
        int count = 0;
        for (int b = 0; b < words(rows); b++) {
            count += Integer.bitCount(bits[b]);
        }
        return count;
    }

    /** How many of rows {@code from … to − 1} are in the set. */
    static int count(int[] bits, int from, int to) {
        int count = 0;
        for (int b = from / WIDTH; b * WIDTH < to; b++) {
            count += Integer.bitCount(bits[b] & rangeBits(b, from, to));
        }
        return count;
    }

    /** The first word from {@code b} on without a row of the set; {@code words} where all have one. */
    public static int firstEmptyWord(int[] bits, int b, int words) {
        int end = b;
        while (end < words && bits[end] != 0) {
            end++;
        }
        return end;
    }

    /** Puts rows {@code from … to − 1} into the set. */
    public static void add(int[] bits, int from, int to) {
        for (int b = from / WIDTH; b * WIDTH < to; b++) {
            bits[b] |= rangeBits(b, from, to);
        }
    }

    /** Takes rows {@code from … to − 1} out of the set. */
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

    /** Puts the rows in a state, see {@link LightRows}, into the set. */
    static void selectState(byte[] states, int rows, int state, int[] bits) {
        selectStates(states, rows, 1 << state, bits);
    }

    /**
     * Puts the rows in any of some states into the set.
     *
     * @param stateMask a bit for each state
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
     * Exchanges rows and columns of a square of bits: bit c of word r and bit r of word c, {@code int[WIDTH]}. Halves of the square
     * change places, then halves of these (Warren, Hacker's Delight, §7-3).
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
