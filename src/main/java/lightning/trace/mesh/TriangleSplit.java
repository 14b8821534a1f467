package lightning.trace.mesh;

import java.util.Arrays;

/**
 * Parts sets of triangles where the surface area heuristic, on a few bins along each axis, expects the fewest blocks of eight triangles to be tested
 * (Wald 2007, On fast Construction of SAH-based Bounding Volume Hierarchies). Scratch memory: one for each thread.
 */
final class TriangleSplit {
    private static final int BINS = 16;
    /** Just less than the bins, so that what lies at the end is in the last. */
    private static final float SPREAD = BINS * 0.9999f;
    /** Below this depth sets are halved by count, which bounds the depth for any input. */
    private static final int MAX_SAH_DEPTH = 50;

    private final TriangleBoxes triangles;
    private final float[] box = new float[3 * BINS * 6];
    private final int[] count = new int[3 * BINS];
    private final double[] above = new double[BINS];
    private final float[] sum = new float[6];
    private final float[] low = new float[3];
    private final float[] scale = new float[3];
    /** Where {@link #best} would split. */
    private int axis;
    private int bin;

    TriangleSplit(TriangleBoxes triangles) {
        this.triangles = triangles;
    }

    /**
     * Parts triangles in two.
     *
     * @param level  how deep their set lies
     * @param first  gets the box of those that are in front afterwards, {@code second} that of the others; both hold nothing before
     * @return where the others begin
     */
    int part(int from, int to, int level, float[] first, float[] second) {
        return level < MAX_SAH_DEPTH && best(from, to) ? parted(from, to, first, second) : halved(from, to, first, second);
    }

    /** Writes where a set is best split to {@link #axis} and {@link #bin}; whether it can be split so at all. */
    private boolean best(int from, int to) {
        range(from, to);
        fill(from, to);
        double best = Double.POSITIVE_INFINITY;
        axis = -1;
        for (int a = 0; a < 3; a++) {
            Arrays.fill(sum, Float.POSITIVE_INFINITY);
            int n = 0;
            for (int b = BINS - 1; b > 0; b--) {
                TriangleBoxes.grow(sum, 0, box, 6 * (a * BINS + b));
                n += count[a * BINS + b];
                above[b] = blocks(n) * TriangleBoxes.area(sum);
            }
            Arrays.fill(sum, Float.POSITIVE_INFINITY);
            n = 0;
            for (int b = 1; b < BINS; b++) {
                TriangleBoxes.grow(sum, 0, box, 6 * (a * BINS + b - 1));
                n += count[a * BINS + b - 1];
                double cost = blocks(n) * TriangleBoxes.area(sum) + above[b];
                if (n > 0 && n < to - from && cost < best) {
                    best = cost;
                    axis = a;
                    bin = b;
                }
            }
        }
        return axis >= 0;
    }

    private static int blocks(int triangles) {
        return (triangles + MeshTree.WIDTH - 1) / MeshTree.WIDTH;
    }

    private void range(int from, int to) {
        for (int a = 0; a < 3; a++) {
            float least = Float.POSITIVE_INFINITY;
            float most = Float.NEGATIVE_INFINITY;
            for (int i = from; i < to; i++) {
                float c = triangles.centre(i, a);
                least = c < least ? c : least;
                most = c > most ? c : most;
            }
            low[a] = least;
            scale[a] = most > least ? SPREAD / (most - least) : 0;
        }
    }

    private int bin(int i, int a) {
        int b = (int) ((triangles.centre(i, a) - low[a]) * scale[a]);
        // A range so small that its inverse is endless.
        return b < BINS ? b : BINS - 1;
    }

    private void fill(int from, int to) {
        Arrays.fill(count, 0);
        Arrays.fill(box, Float.POSITIVE_INFINITY);
        for (int i = from; i < to; i++) {
            for (int a = 0; a < 3; a++) {
                int b = a * BINS + bin(i, a);
                count[b]++;
                TriangleBoxes.grow(box, 6 * b, triangles.boxes, 6 * i);
            }
        }
    }

    /** Moves the triangles before the best place to the front and returns where the others begin. */
    private int parted(int from, int to, float[] first, float[] second) {
        int place = from;
        int high = to - 1;
        while (place <= high) {
            if (bin(place, axis) < bin) {
                place++;
            } else {
                triangles.swap(place, high--);
            }
        }
        for (int b = 0; b < BINS; b++) {
            TriangleBoxes.grow(b < bin ? first : second, 0, box, 6 * (axis * BINS + b));
        }
        return place;
    }

    private int halved(int from, int to, float[] first, float[] second) {
        int middle = (from + to) >>> 1;
        for (int i = from; i < to; i++) {
            TriangleBoxes.grow(i < middle ? first : second, 0, triangles.boxes, 6 * i);
        }
        return middle;
    }
}
