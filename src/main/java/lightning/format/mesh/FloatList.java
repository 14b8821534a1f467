package lightning.format.mesh;

import java.util.Arrays;

/** Growable list of floats. */
public final class FloatList {
    private float[] values = new float[16];
    private int size;

    public void add(float v) {
        if (size == values.length) {
            values = Arrays.copyOf(values, IntList.grownCapacity(size));
        }
        values[size++] = v;
    }

    public float get(int index) {
        return values[index];
    }

    public int size() {
        return size;
    }

    /** Returns the backing array, which may be longer than the list; replaced when it is full. */
    public float[] array() {
        return values;
    }

    public float[] toArray() {
        return Arrays.copyOf(values, size);
    }
}
