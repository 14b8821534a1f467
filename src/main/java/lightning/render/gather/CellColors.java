package lightning.render.gather;

import java.util.Arrays;

/**
 * Mean texture color of what rays hit in each cell. Many threads add to it. The sums are whole numbers, so they do not depend on the
 * order.
 */
final class CellColors {
    private static final int SEGMENTS = 64;
    /** Units of a color of 1: the sums of 2³¹ rays fit into a long. */
    private static final double SCALE = 0x1p32;

    private final Segment[] segments = new Segment[SEGMENTS];

    CellColors() {
        Arrays.setAll(segments, i -> new Segment());
    }

    /** Adds a color, 0…1, to a cell. */
    void add(long key, float red, float green, float blue) {
        segments[(int) (key >>> 58)].add(key, (long) (red * SCALE), (long) (green * SCALE), (long) (blue * SCALE));
    }

    /** Returns one channel of the mean of an existing cell: 0 red, 1 green, 2 blue. Not while another thread adds to it. */
    float mean(long key, int channel) {
        Segment segment = segments[(int) (key >>> 58)];
        int slot = segment.slot(key);
        return (float) (segment.sums[4 * slot + channel] / (segment.sums[4 * slot + 3] * SCALE));
    }

    /** Part of the cells, with open addressing. */
    private static final class Segment {
        private long[] keys = new long[64];
        /** Red, green, blue and number of rays of each slot; no ray in an empty slot. */
        private long[] sums = new long[4 * 64];
        private int count;

        /** Returns the slot of a key, or the empty one where it belongs. */
        int slot(long key) {
            int mask = keys.length - 1;
            int slot = (int) key & mask;
            while (sums[4 * slot + 3] > 0 && keys[slot] != key) {
                slot = slot + 1 & mask;
            }
            return slot;
        }

        synchronized void add(long key, long red, long green, long blue) {
            int slot = slot(key);
            if (sums[4 * slot + 3] == 0 && 2 * ++count > keys.length) {
                grow();
                slot = slot(key);
            }
            keys[slot] = key;
            sums[4 * slot] += red;
            sums[4 * slot + 1] += green;
            sums[4 * slot + 2] += blue;
            sums[4 * slot + 3]++;
        }

        private void grow() {
            long[] oldKeys = keys;
            long[] oldSums = sums;
            keys = new long[2 * oldKeys.length];
            sums = new long[4 * keys.length];
            for (int i = 0; i < oldKeys.length; i++) {
                if (oldSums[4 * i + 3] > 0) {
                    int slot = slot(oldKeys[i]);
                    keys[slot] = oldKeys[i];
                    System.arraycopy(oldSums, 4 * i, sums, 4 * slot, 4);
                }
            }
        }
    }
}
