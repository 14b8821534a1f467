package lightning.render.gather.cell;

import java.util.Arrays;

/**
 * Set of cells that many threads add to, with the index that was added to each and comes first. The result does not depend on the order
 * in which they are added.
 */
public final class CellTable {
    private static final int SEGMENTS = 64;
    private static final long EMPTY = -1;

    private final Segment[] segments = new Segment[SEGMENTS];

    public CellTable() {
        Arrays.setAll(segments, i -> new Segment());
    }

    /** Adds an index to a cell; the lowest comes first. */
    public void add(long key, int index) {
        add(key, index, index);
    }

    /**
     * Adds an index to a cell.
     *
     * @param rank 0 or more; that of the lowest rank comes first, and of several the lowest
     */
    public void add(long key, int index, int rank) {
        segments[(int) (key >>> 58)].add(key, index, rank);
    }

    /** Returns the first index of each cell, ascending. */
    public int[] firsts() {
        int count = 0;
        for (Segment segment : segments) {
            count += segment.count;
        }
        int[] firsts = new int[count];
        int at = 0;
        for (Segment segment : segments) {
            for (int slot = 0; slot < segment.capacity(); slot++) {
                if (!segment.isEmpty(slot)) {
                    firsts[at++] = segment.first(slot);
                }
            }
        }
        Arrays.parallelSort(firsts);
        return firsts;
    }

    /** Sets the number of an existing cell. Not thread-safe. */
    public void setNumber(long key, int number) {
        Segment segment = segments[(int) (key >>> 58)];
        int slot = segment.slot(key);
        segment.number[slot] = number;
    }

    /** Returns the number of a cell; −1 if it has none. */
    public int number(long key) {
        Segment segment = segments[(int) (key >>> 58)];
        int slot = segment.slot(key);
        return segment.isEmpty(slot) ? -1 : segment.number[slot];
    }

    /** Part of the cells, with open addressing. */
    private static final class Segment {
        /** Key and {@link #entry} of each slot, so that they share a cache line. */
        private long[] slots = emptySlots(256);
        private int[] number = new int[256];
        private int count;

        private static long[] emptySlots(int capacity) {
            long[] slots = new long[2 * capacity];
            for (int slot = 0; slot < capacity; slot++) {
                slots[2 * slot + 1] = EMPTY;
            }
            return slots;
        }

        int capacity() {
            return number.length;
        }

        boolean isEmpty(int slot) {
            return slots[2 * slot + 1] == EMPTY;
        }

        int first(int slot) {
            return (int) slots[2 * slot + 1];
        }

        /** Returns the slot of a key, or the empty one where it belongs. */
        int slot(long key) {
            int mask = number.length - 1;
            int slot = (int) key & mask;
            while (slots[2 * slot] != key && !isEmpty(slot)) {
                slot = slot + 1 & mask;
            }
            return slot;
        }

        synchronized void add(long key, int index, int rank) {
            int slot = slot(key);
            if (!isEmpty(slot)) {
                slots[2 * slot + 1] = Math.min(slots[2 * slot + 1], entry(index, rank));
                return;
            }
            put(slot, key, entry(index, rank), -1);
            if (2 * ++count > capacity()) {
                grow();
            }
        }

        private void put(int slot, long key, long entry, int itsNumber) {
            slots[2 * slot] = key;
            slots[2 * slot + 1] = entry;
            number[slot] = itsNumber;
        }

        private void grow() {
            long[] oldSlots = slots;
            int[] oldNumber = number;
            slots = emptySlots(2 * oldNumber.length);
            number = new int[2 * oldNumber.length];
            for (int i = 0; i < oldNumber.length; i++) {
                if (oldSlots[2 * i + 1] != EMPTY) {
                    put(slot(oldSlots[2 * i]), oldSlots[2 * i], oldSlots[2 * i + 1], oldNumber[i]);
                }
            }
        }
    }

    /** Returns a rank and an index as one number: the lowest comes first. */
    private static long entry(int index, int rank) {
        return (long) rank << Integer.SIZE | index;
    }
}
