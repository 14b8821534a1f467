package lightning.render.shading.composition;

import java.util.Arrays;

/** Adds products of columns in one pass over a run of rows: none is negative, so the sum may begin with the first. One instance per thread. */
final class ProductSum {
    private static final int MAX = 3;

    private final float[][] left = new float[MAX][];
    private final float[][] right = new float[MAX][];
    private int count;
    private boolean isBegun;
    private float[] to = {};
    private int from;
    private int end;

    /** Starts the sum in rows {@code first … last − 1}. @param column receives it */
    void start(float[] column, int first, int last) {
        to = column;
        from = first;
        end = last;
        count = 0;
        isBegun = false;
    }

    /** Adds a product. */
    void add(float[] a, float[] b) {
        if (count == MAX) {
            write();
        }
        left[count] = a;
        right[count++] = b;
    }

    /** Adds the sum of two products. */
    void addTwo(float[] a, float[] b, float[] c, float[] d) {
        write();
        for (int i = from; i < end; i++) {
            to[i] += a[i] * b[i] + c[i] * d[i];
        }
    }

    /** Writes what was added so far. */
    void write() {
        if (!isBegun && count == 0) {
            Arrays.fill(to, from, end, 0);
        } else if (!isBegun) {
            begin(left[0], right[0], left[1], right[1], left[2], right[2]);
        } else {
            for (int k = 0; k < count; k++) {
                addProduct(left[k], right[k]);
            }
        }
        isBegun = true;
        count = 0;
    }

    private void begin(float[] a, float[] b, float[] c, float[] d, float[] e, float[] f) {
        float[] out = to;
        if (count == 1) {
            for (int i = from; i < end; i++) {
                out[i] = a[i] * b[i];
            }
        } else if (count == 2) {
            for (int i = from; i < end; i++) {
                out[i] = a[i] * b[i] + c[i] * d[i];
            }
        } else {
            for (int i = from; i < end; i++) {
                out[i] = a[i] * b[i] + c[i] * d[i] + e[i] * f[i];
            }
        }
    }

    private void addProduct(float[] a, float[] b) {
        float[] out = to;
        for (int i = from; i < end; i++) {
            out[i] += a[i] * b[i];
        }
    }
}
