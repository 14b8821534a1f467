package lightning.render.gather;

import java.util.Arrays;

/**
 * Set of cells that many threads add to, with the index that was added to each and comes first. The result does not depend on the order
 * in which they are added.
 */
final class CellTable {
    private static final int SEGMENTS = 64;

    private final Segment[] segments = new Segment[SEGMENTS];

    CellTable() {
        Arrays.setAll(segments, i -> new Segment());
    }

    /** Adds an index to a cell; the lowest comes first. */
    void add(long key, int index) {
        add(key, index, index);
    }

    /**
     * Adds an index to a cell.
     *
     * @param rank that of the lowest rank comes first, and of several the lowest
     */
    void add(long key, int index, int rank) {
        segments[(int) (key >>> 58)].add(key, index, rank);
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
        private int[] rank = new int[256];
        private int count;

        Segment() {
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

        synchronized void add(long key, int index, int itsRank) {
            int slot = slot(key);
            if (first[slot] >= 0) {
                if (itsRank < rank[slot] || itsRank == rank[slot] && index < first[slot]) {
                    first[slot] = index;
                    rank[slot] = itsRank;
                }
                return;
            }
            put(slot, key, index, itsRank, -1);
            if (2 * ++count > keys.length) {
                grow();
            }
        }

        private void put(int slot, long key, int index, int itsRank, int itsNumber) {
            keys[slot] = key;
            rank[slot] = itsRank;
            first[slot] = index;
            number[slot] = itsNumber;
        }

        private void grow() {
            long[] oldKeys = keys;
            int[] oldFirst = first;
            int[] oldRank = rank;
            int[] oldNumber = number;
            keys = new long[2 * oldKeys.length];
            first = new int[keys.length];
            rank = new int[keys.length];
            number = new int[keys.length];
            Arrays.fill(first, -1);
            for (int i = 0; i < oldKeys.length; i++) {
                if (oldFirst[i] >= 0) {
                    put(slot(oldKeys[i]), oldKeys[i], oldFirst[i], oldRank[i], oldNumber[i]);
                }
            }
        }
    }
}
