package lightning.trace;

/** The few shapes that a bundle of rays can meet, each with its box. Reused; not shared between threads. */
public final class Candidates {
    int count;
    int[] shape = new int[16];
    float[] boxes = new float[6 * 16];

    /** All shapes of a small scene. */
    static Candidates all(Bvh bvh) {
        Candidates c = new Candidates();
        for (int s = 0; s < bvh.shapes.count; s++) {
            c.add(bvh, s);
        }
        return c;
    }

    /** Adds a shape. */
    private void add(Bvh bvh, int s) {
        if (count == shape.length) {
            shape = java.util.Arrays.copyOf(shape, 2 * count);
            boxes = java.util.Arrays.copyOf(boxes, 12 * count);
        }
        System.arraycopy(bvh.shapeBoxes, 6 * s, boxes, 6 * count, 6);
        shape[count++] = s;
    }

    /** Moves a shape that blocks rays to the front: the next packet is likely to be blocked by it too. */
    void promote(int c) {
        for (int i = 6 * c - 1; i >= 0; i--) {
            float b = boxes[i + 6];
            boxes[i + 6] = boxes[i];
            boxes[i] = b;
        }
        int s = shape[c];
        System.arraycopy(shape, 0, shape, 1, c);
        shape[0] = s;
    }
}
