package lightning.render.trace.tree;

import java.util.Arrays;

/**
 * Top-down binned SAH builder: minimizes the expected number of tested boxes and primitives (Wald 2007, On fast Construction of
 * SAH-based Bounding Volume Hierarchies).
 */
final class BvhBuilder {
    private static final int BINS = 16;
    /** Below this depth nodes are halved by count, which bounds the depth for any input. */
    private static final int MAX_SAH_DEPTH = 60;

    final int[] child;
    final float[] boxes;
    final byte[] axis;
    int depth;

    private final float[] primitiveBoxes;
    private final int[] order;
    private int nodes;
    private final int[] binCount = new int[3 * BINS];
    private final float[] binBox = new float[3 * BINS * 6];
    private final float[] box = new float[6];
    private final float[] centers = new float[6];
    private final double[] areaAbove = new double[BINS];

    BvhBuilder(float[] primitiveBoxes) {
        this.primitiveBoxes = primitiveBoxes;
        int count = primitiveBoxes.length / 6;
        int inner = Math.max(0, count - 1);
        child = new int[2 * inner];
        boxes = new float[12 * inner];
        axis = new byte[inner];
        order = new int[count];
        Arrays.setAll(order, i -> i);
        if (inner > 0) {
            build(0, count, 1);
        }
    }

    /** Builds the subtree over {@code order[from … to − 1]} and returns it as a child. */
    private int build(int from, int to, int level) {
        if (to - from == 1) {
            return ~order[from];
        }
        depth = Math.max(depth, level);
        int node = nodes++;
        int middle = level > MAX_SAH_DEPTH ? from : split(from, to, node);
        if (middle == from || middle == to) {
            middle = (from + to) >>> 1;
        }
        bound(from, middle, boxes, 12 * node);
        bound(middle, to, boxes, 12 * node + 6);
        child[2 * node] = build(from, middle, level + 1);
        child[2 * node + 1] = build(middle, to, level + 1);
        return node;
    }

    /** Partitions the primitives and returns the start of the second side. */
    private int split(int from, int to, int node) {
        setEmpty(centers, 0);
        for (int i = from; i < to; i++) {
            for (int a = 0; a < 3; a++) {
                float c = center(order[i], a);
                centers[a] = Math.min(centers[a], c);
                centers[3 + a] = Math.max(centers[3 + a], c);
            }
        }
        fillBins(from, to);
        double best = Double.POSITIVE_INFINITY;
        int bestAxis = -1;
        int bestBin = 0;
        for (int a = 0; a < 3; a++) {
            setEmpty(box, 0);
            int count = 0;
            for (int b = BINS - 1; b > 0; b--) {
                grow(box, 0, binBox, 6 * (a * BINS + b));
                count += binCount[a * BINS + b];
                areaAbove[b] = count * area(box);
            }
            setEmpty(box, 0);
            count = 0;
            for (int b = 1; b < BINS; b++) {
                grow(box, 0, binBox, 6 * (a * BINS + b - 1));
                count += binCount[a * BINS + b - 1];
                double cost = count * area(box) + areaAbove[b];
                if (count > 0 && count < to - from && cost < best) {
                    best = cost;
                    bestAxis = a;
                    bestBin = b;
                }
            }
        }
        if (bestAxis < 0) {
            return from;
        }
        axis[node] = (byte) bestAxis;
        int low = from;
        int high = to - 1;
        while (low <= high) {
            if (bin(order[low], bestAxis) < bestBin) {
                low++;
            } else {
                int o = order[low];
                order[low] = order[high];
                order[high--] = o;
            }
        }
        return low;
    }

    private void fillBins(int from, int to) {
        Arrays.fill(binCount, 0);
        for (int b = 0; b < 3 * BINS; b++) {
            setEmpty(binBox, 6 * b);
        }
        for (int i = from; i < to; i++) {
            for (int a = 0; a < 3; a++) {
                int b = a * BINS + bin(order[i], a);
                binCount[b]++;
                grow(binBox, 6 * b, primitiveBoxes, 6 * order[i]);
            }
        }
    }

    private float center(int primitive, int a) {
        return 0.5f * primitiveBoxes[6 * primitive + a] + 0.5f * primitiveBoxes[6 * primitive + 3 + a];
    }

    /** Returns the bin of a primitive; 0 if all centers are equal, or NaN because boxes are infinite. */
    private int bin(int primitive, int a) {
        float from = centers[a];
        float range = centers[3 + a] - from;
        return range > 0 ? Math.min(BINS - 1, (int) ((center(primitive, a) - from) / range * BINS)) : 0;
    }

    private void bound(int from, int to, float[] into, int at) {
        setEmpty(into, at);
        for (int i = from; i < to; i++) {
            grow(into, at, primitiveBoxes, 6 * order[i]);
        }
    }

    static void setEmpty(float[] b, int at) {
        Arrays.fill(b, at, at + 3, Float.POSITIVE_INFINITY);
        Arrays.fill(b, at + 3, at + 6, Float.NEGATIVE_INFINITY);
    }

    static void grow(float[] b, int at, float[] other, int i) {
        for (int a = 0; a < 3; a++) {
            // Not Math.min and max: their handling of ±0 and NaN costs half of the build time.
            b[at + a] = other[i + a] < b[at + a] ? other[i + a] : b[at + a];
            b[at + 3 + a] = other[i + 3 + a] > b[at + 3 + a] ? other[i + 3 + a] : b[at + 3 + a];
        }
    }

    private static double area(float[] b) {
        return area(b, 0);
    }

    /** Returns half the surface area of the box {@code b[at … at + 5]}; 0 if it is empty. */
    static double area(float[] b, int at) {
        double x = (double) b[at + 3] - b[at];
        double y = (double) b[at + 4] - b[at + 1];
        double z = (double) b[at + 5] - b[at + 2];
        return x < 0 ? 0 : x * y + y * z + z * x;
    }
}
