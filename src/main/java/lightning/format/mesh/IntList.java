package lightning.format.mesh;

import java.util.Arrays;

/** Whole numbers of which it is not known how many will come. */
public final class IntList {
    /** As long as arrays may be in every Java. */
    private static final int MOST = Integer.MAX_VALUE - 64;

    private int[] numbers = new int[16];
    private int size;

    public void add(int v) {
        if (size == numbers.length) {
            numbers = Arrays.copyOf(numbers, larger(size));
        }
        numbers[size++] = v;
    }

    public int get(int index) {
        return numbers[index];
    }

    public int size() {
        return size;
    }

    public void clear() {
        size = 0;
    }

    /** The array behind it, with room for more at its end; replaced when it is full. */
    public int[] array() {
        return numbers;
    }

    public int[] toArray() {
        return Arrays.copyOf(numbers, size);
    }

    /** Half as long again, so that what is copied in all is no more than three times what is there in the end. */
    static int larger(int size) {
        return (int) Math.min(MOST, size + (size >> 1) + 16L);
    }
}
