package lightning.render.trace.mesh;

import java.util.Arrays;

/**
 * Parts sets of triangles where the surface area heuristic, on a few bins along each axis, expects the fewest blocks of eight triangles to be tested
 * (Wald 2007, On fast Construction of SAH-based Bounding Volume Hierarchies). Scratch memory: one for each thread.
 */
final class TriangleSplitter {
    private static final int BINS = 16;
    /** Just less than the bins, so that what lies at the end is in the last. */
    private static final float BIN_RANGE = BINS * 0.9999f;
    /** Below this depth sets are halved by count, which bounds the depth for any input. */
    private static final int MAX_SAH_DEPTH = 50;

    private final TriangleBoxes triangles;
    private final float[] box = new float[3 * BINS * 6];
    private final int[] count = new int[3 * BINS];
    private final double[] costAbove = new double[BINS];
    private final float[] mergedBox = new float[6];
    private final float[] low = new float[3];
    private final float[] scale = new float[3];
    /** Of sets of more triangles about half as many are looked at: enough to tell where to split. */
    private static final int SAMPLING_THRESHOLD = 2048;

    /** Which triangles of a set are looked at: one in so many. Odd, as files list triangles in pairs. */
    private int step;
    /** Where {@link #findBestSplit} would split. */
    private int axis;
    private int bin;

    TriangleSplitter(TriangleBoxes triangles) {
        this.triangles = triangles;
    }

    /**
     * Parts triangles in two.
     *
     * @param level  how deep their set lies
     * @param first  gets the box of those that are in front afterwards, {@code second} that of the others; both hold nothing before
     * @return where the others begin
     */
    int split(int from, int to, int level, float[] first, float[] second) {
        return level < MAX_SAH_DEPTH && findBestSplit(from, to) ? splitAtBin(from, to, first, second)
                : splitInHalf(from, to, first, second);
    }

    /** Writes where a set is best split to {@link #axis} and {@link #bin}; whether it can be split so at all. */
    private boolean findBestSplit(int from, int to) {
        step = to - from > SAMPLING_THRESHOLD ? 2 * (to - from) / SAMPLING_THRESHOLD | 1 : 1;
        computeRanges(from, to);
        fillBins(from, to);
        int sampled = (to - from + step - 1) / step;
        double minCost = Double.POSITIVE_INFINITY;
        axis = -1;
        for (int a = 0; a < 3; a++) {
            Arrays.fill(mergedBox, Float.POSITIVE_INFINITY);
            int n = 0;
            double cost = 0;
            for (int b = BINS - 1; b > 0; b--) {
                // Of small sets most bins are empty.
                if (count[a * BINS + b] > 0) {
                    TriangleBoxes.grow(mergedBox, 0, box, 6 * (a * BINS + b));
                    n += count[a * BINS + b];
                    cost = blocks(n * step) * TriangleBoxes.area(mergedBox);
                }
                costAbove[b] = cost;
            }
            Arrays.fill(mergedBox, Float.POSITIVE_INFINITY);
            n = 0;
            for (int b = 1; b < BINS; b++) {
                // Behind an empty bin it is split as before it.
                if (count[a * BINS + b - 1] == 0) {
                    continue;
                }
                TriangleBoxes.grow(mergedBox, 0, box, 6 * (a * BINS + b - 1));
                n += count[a * BINS + b - 1];
                cost = blocks(n * step) * TriangleBoxes.area(mergedBox) + costAbove[b];
                if (n < sampled && cost < minCost) {
                    minCost = cost;
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

    /** Finds where the bins are: one pass over all axes, for large sets do not fit into the processor's cache. */
    private void computeRanges(int from, int to) {
        float[] b = triangles.boxes;
        float lowX = Float.POSITIVE_INFINITY;
        float lowY = lowX;
        float lowZ = lowX;
        float highX = Float.NEGATIVE_INFINITY;
        float highY = highX;
        float highZ = highX;
        for (int i = 6 * from; i < 6 * to; i += 6 * step) {
            float x = b[i] - b[i + 3];
            float y = b[i + 1] - b[i + 4];
            float z = b[i + 2] - b[i + 5];
            lowX = x < lowX ? x : lowX;
            lowY = y < lowY ? y : lowY;
            lowZ = z < lowZ ? z : lowZ;
            highX = x > highX ? x : highX;
            highY = y > highY ? y : highY;
            highZ = z > highZ ? z : highZ;
        }
        setRange(0, lowX, highX);
        setRange(1, lowY, highY);
        setRange(2, lowZ, highZ);
    }

    private void setRange(int a, float min, float max) {
        low[a] = min;
        scale[a] = max > min ? BIN_RANGE / (max - min) : 0;
    }

    private int bin(float center, int a) {
        int b = (int) ((center - low[a]) * scale[a]);
        // A range so small that its inverse is endless, or a triangle that was not looked at; NaN makes 0.
        return b < 0 ? 0 : b < BINS ? b : BINS - 1;
    }

    private void fillBins(int from, int to) {
        Arrays.fill(count, 0);
        Arrays.fill(box, Float.POSITIVE_INFINITY);
        float[] b = triangles.boxes;
        for (int i = 6 * from; i < 6 * to; i += 6 * step) {
            addToBin(bin(b[i] - b[i + 3], 0), b, i);
            addToBin(BINS + bin(b[i + 1] - b[i + 4], 1), b, i);
            addToBin(2 * BINS + bin(b[i + 2] - b[i + 5], 2), b, i);
        }
    }

    /** Makes a bin hold one more. Written as branches, nearly all of which are not taken: blending would store six numbers each time. */
    private void addToBin(int bin, float[] b, int i) {
        count[bin]++;
        float[] to = box;
        int at = 6 * bin;
        if (b[i] < to[at]) {
            to[at] = b[i];
        }
        if (b[i + 1] < to[at + 1]) {
            to[at + 1] = b[i + 1];
        }
        if (b[i + 2] < to[at + 2]) {
            to[at + 2] = b[i + 2];
        }
        if (b[i + 3] < to[at + 3]) {
            to[at + 3] = b[i + 3];
        }
        if (b[i + 4] < to[at + 4]) {
            to[at + 4] = b[i + 4];
        }
        if (b[i + 5] < to[at + 5]) {
            to[at + 5] = b[i + 5];
        }
    }

    /** Moves the triangles before the best place to the front and returns where the others begin. */
    private int splitAtBin(int from, int to, float[] first, float[] second) {
        int boundary = from;
        int high = to - 1;
        while (boundary <= high) {
            if (bin(triangles.doubledCenter(boundary, axis), axis) < bin) {
                boundary++;
            } else {
                triangles.swap(boundary, high--);
            }
        }
        if (step > 1) {
            triangles.enclose(from, boundary, first);
            triangles.enclose(boundary, to, second);
        }
        for (int b = 0; step == 1 && b < BINS; b++) {
            TriangleBoxes.grow(b < bin ? first : second, 0, box, 6 * (axis * BINS + b));
        }
        return boundary;
    }

    private int splitInHalf(int from, int to, float[] first, float[] second) {
        int middle = (from + to) >>> 1;
        triangles.enclose(from, middle, first);
        triangles.enclose(middle, to, second);
        return middle;
    }
}
