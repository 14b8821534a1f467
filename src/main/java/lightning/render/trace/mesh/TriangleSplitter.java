package lightning.render.trace.mesh;

import java.util.Arrays;

/**
 * Binned SAH splitter: minimizes the expected number of tested blocks of eight triangles (Wald 2007, On fast Construction of
 * SAH-based Bounding Volume Hierarchies). Holds scratch memory: use one per thread.
 */
final class TriangleSplitter {
    private static final int BINS = 16;
    /** Slightly less than the number of bins, so that the end of the range falls into the last bin. */
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
    /** Larger sets are sampled, which suffices to choose a split. */
    private static final int SAMPLING_THRESHOLD = 2048;

    /** Sampling interval of a set's triangles. Odd, because files list triangles in pairs. */
    private int step;
    /** Best split found by {@link #findBestSplit}. */
    private int axis;
    private int bin;

    TriangleSplitter(TriangleBoxes triangles) {
        this.triangles = triangles;
    }

    /**
     * Splits triangles in two.
     *
     * @param level depth of their set
     * @param first receives the bounds of the triangles in front, {@code second} those of the others; both are empty before
     * @return start of the second part
     */
    int split(int from, int to, int level, float[] first, float[] second) {
        return level < MAX_SAH_DEPTH && findBestSplit(from, to) ? splitAtBin(from, to, first, second)
                : splitInHalf(from, to, first, second);
    }

    /** Writes the best split of a set to {@link #axis} and {@link #bin}; returns false if there is none. */
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
                // Most bins of small sets are empty.
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
                // A split after an empty bin is the same as one before it.
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

    private static int blocks(int strips) {
        return (strips + MeshTree.STRIPS - 1) / MeshTree.STRIPS;
    }

    /** Computes the range of the bins. One pass over all axes, because large sets do not fit into the CPU cache. */
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
        // Handles a range so small that its inverse is infinite, and triangles that were not sampled; NaN becomes 0.
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

    /** Adds a box to a bin. Written with branches, which are rarely taken: blending would store six numbers each time. */
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

    /** Moves the triangles before the best split to the front and returns the start of the others. */
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
