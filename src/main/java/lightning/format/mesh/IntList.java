package lightning.format.mesh;

import java.util.Arrays;

/** Growable list of ints. */
public final class IntList {
    /** Maximum array length supported by all Java implementations. */
    private static final int MAX_SIZE = Integer.MAX_VALUE - 64;

    private int[] values = new int[16];
    private int size;

    public void add(int v) {
        if (size == values.length) {
            values = Arrays.copyOf(values, grownCapacity(size));
        }
        values[size++] = v;
    }

    public int get(int index) {
        return values[index];
    }

    public int size() {
        return size;
    }

    public void clear() {
        size = 0;
    }

    /** Removes the last values. */
    public void truncate(int newSize) {
        size = Math.min(size, newSize);
    }

    /** Returns the backing array, which may be longer than the list; replaced when it is full. */
    public int[] array() {
        return values;
    }

    public int[] toArray() {
        return Arrays.copyOf(values, size);
    }

    /** Returns a capacity 1.5 times as large, so that all copies together are at most three times the final size. */
    static int grownCapacity(int size) {
        return (int) Math.min(MAX_SIZE, size + (size >> 1) + 16L);
    }
}
