package lightning.format.mesh;

import java.util.Arrays;

/** Whole numbers of which it is not known how many will come. */
public final class IntList {
    /** As long as arrays may be in every Java. */
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

    /** The array behind it, with room for more at its end; replaced when it is full. */
    public int[] array() {
        return values;
    }

    public int[] toArray() {
        return Arrays.copyOf(values, size);
    }

    /** Half as long again, so that what is copied in all is no more than three times what is there in the end. */
    static int grownCapacity(int size) {
        return (int) Math.min(MAX_SIZE, size + (size >> 1) + 16L);
    }
}
