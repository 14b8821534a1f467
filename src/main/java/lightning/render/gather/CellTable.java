package lightning.render.gather;

import java.util.Arrays;

/**
 * Set of cells that many threads add to, with the index that was added to each and comes first. The result does not depend on the order
 * in which they are added.
 */
final class CellTable {
    private static final int SEGMENTS = 64;

    private final Segment[] segments = new Segment[SEGMENTS];

    private CellTable(int factor) {
        Arrays.setAll(segments, i -> new Segment(factor));
    }

    /** Returns a table in which the lowest index comes first. */
    static CellTable ofLowest() {
        return new CellTable(1);
    }

    /** Returns a table in which any index may come first, by {@link CellKeys#rank}. */
    static CellTable ofRandom() {
        return new CellTable(CellKeys.RANK_FACTOR);
    }

    /** Adds an index to a cell. */
    void add(long key, int index) {
        segments[(int) (key >>> 58)].add(key, index);
    }

    /** Returns the first index of each cell, ascending. */
    int[] firsts() {
        int count = 0;
        for (Segment segment : segments) {
            count += segment.count;
        }
        int[] firsts = new int[count];
        int at = 0;
        for (Segment segment : segments) {
            for (int slot = 0; slot < segment.first.length; slot++) {
                if (segment.first[slot] >= 0) {
                    firsts[at++] = segment.first[slot];
                }
            }
        }
        Arrays.parallelSort(firsts);
        return firsts;
    }

    /** Sets the number of an existing cell. Not thread-safe. */
    void setNumber(long key, int number) {
        Segment segment = segments[(int) (key >>> 58)];
        int slot = segment.slot(key);
        segment.number[slot] = number;
    }

    /** Returns the number of a cell; −1 if it has none. */
    int number(long key) {
        Segment segment = segments[(int) (key >>> 58)];
        int slot = segment.slot(key);
        return segment.first[slot] < 0 ? -1 : segment.number[slot];
    }

    /** Part of the cells, with open addressing. */
    private static final class Segment {
        private long[] keys = new long[256];
        /** −1 in an empty slot. */
        private int[] first = new int[256];
        private int[] number = new int[256];
        private int count;
        private final int factor;

        Segment(int factor) {
            this.factor = factor;
            Arrays.fill(first, -1);
        }

        /** Returns the slot of a key, or the empty one where it belongs. */
        int slot(long key) {
            int mask = keys.length - 1;
            int slot = (int) key & mask;
            while (first[slot] >= 0 && keys[slot] != key) {
                slot = slot + 1 & mask;
            }
            return slot;
        }

        synchronized void add(long key, int index) {
            int slot = slot(key);
            if (first[slot] >= 0) {
                first[slot] = CellKeys.rank(index, factor) < CellKeys.rank(first[slot], factor) ? index : first[slot];
                return;
            }
            put(slot, key, index, -1);
            if (2 * ++count > keys.length) {
                grow();
            }
        }

        private void put(int slot, long key, int index, int itsNumber) {
            keys[slot] = key;
            first[slot] = index;
            number[slot] = itsNumber;
        }

        private void grow() {
            long[] oldKeys = keys;
            int[] oldFirst = first;
            int[] oldNumber = number;
            keys = new long[2 * oldKeys.length];
            first = new int[keys.length];
            number = new int[keys.length];
            Arrays.fill(first, -1);
            for (int i = 0; i < oldKeys.length; i++) {
                if (oldFirst[i] >= 0) {
                    put(slot(oldKeys[i]), oldKeys[i], oldFirst[i], oldNumber[i]);
                }
            }
        }
    }
}
