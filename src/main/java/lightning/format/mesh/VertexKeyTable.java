package lightning.format.mesh;

import java.util.Arrays;

/**
 * Hash table that assigns vertex indices to corners: corners with the same three keys share a vertex. Uses open addressing
 * (Knuth, The Art of Computer Programming 3, §6.4, algorithm L), because ten million objects would take a gigabyte.
 */
public final class VertexKeyTable {
    private static final int KEY_SIZE = 3;

    private final IntList keys = new IntList();
    private int[] slots = new int[64];

    public VertexKeyTable() {
        Arrays.fill(slots, -1);
    }

    public int size() {
        return keys.size() / KEY_SIZE;
    }

    /** Returns a key of a corner. */
    public int key(int corner, int component) {
        return keys.get(KEY_SIZE * corner + component);
    }

    /** Returns the index of a corner, assigned from 0 in order of first occurrence. */
    public int findOrAdd(int a, int b, int c) {
        int mask = slots.length - 1;
        int slot = hash(a, b, c) & mask;
        while (slots[slot] >= 0) {
            int corner = slots[slot];
            if (key(corner, 0) == a && key(corner, 1) == b && key(corner, 2) == c) {
                return corner;
            }
            slot = slot + 1 & mask;
        }
        slots[slot] = size();
        keys.add(a);
        keys.add(b);
        keys.add(c);
        if (2 * size() > slots.length) {
            grow();
        }
        return size() - 1;
    }

    private void grow() {
        slots = new int[2 * slots.length];
        Arrays.fill(slots, -1);
        int mask = slots.length - 1;
        for (int corner = 0; corner < size(); corner++) {
            int slot = hash(key(corner, 0), key(corner, 1), key(corner, 2)) & mask;
            while (slots[slot] >= 0) {
                slot = slot + 1 & mask;
            }
            slots[slot] = corner;
        }
    }

    /** Mixes the keys as SplitMix64 does (Steele, Lea and Flood, Fast splittable pseudorandom number generators, 2014). */
    private static int hash(int a, int b, int c) {
        long h = a * 0x9E3779B97F4A7C15L + b;
        h = (h ^ h >>> 30) * 0xBF58476D1CE4E5B9L + c;
        h = (h ^ h >>> 27) * 0x94D049BB133111EBL;
        return (int) (h ^ h >>> 31);
    }
}
