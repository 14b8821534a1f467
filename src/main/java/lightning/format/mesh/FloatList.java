package lightning.format.mesh;

import java.util.Arrays;

/** Numbers of which it is not known how many will come. */
public final class FloatList {
    private float[] numbers = new float[16];
    private int size;

    public void add(float v) {
        if (size == numbers.length) {
            numbers = Arrays.copyOf(numbers, IntList.larger(size));
        }
        numbers[size++] = v;
    }

    public float get(int index) {
        return numbers[index];
    }

    public int size() {
        return size;
    }

    /** The array behind it, with room for more at its end; replaced when it is full. */
    public float[] array() {
        return numbers;
    }

    public float[] toArray() {
        return Arrays.copyOf(numbers, size);
    }
}
