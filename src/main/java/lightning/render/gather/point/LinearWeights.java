package lightning.render.gather.point;

import java.util.Arrays;

/**
 * Changes the weights of points around a place so that their mean is right for values that change linearly along the surface: local linear
 * regression, W. Cleveland, Robust locally weighted regression and smoothing scatterplots, 1979. A mean with the weights alone is drawn to
 * the side on which more points lie: beside edges, and where large cells meet small ones.
 *
 * <p>A weight w becomes w · max(0, 1 − mᵀ(M + λI)⁻¹d). d is the offset of a point along the surface, m = ∑ w d and M = ∑ w d dᵀ. λ keeps
 * points that lie on one line, or on one side only, from being extrapolated. No weight becomes negative, so no light does.
 *
 * <p>Holds scratch memory: use one instance per thread.
 */
public final class LinearWeights {
    /** λ relative to the trace of M. */
    private static final float DAMPING = 0.02f;

    private float[] weight = new float[16];
    /** Coordinates of each point along the surface. */
    private float[] u = new float[16];
    private float[] v = new float[16];
    private int count;
    private float inverseUnit;
    /** Two directions along the surface. */
    private float ux, uy, uz;
    private float vx, vy, vz;

    /**
     * Begins a place, with no points.
     *
     * @param nx   component x of the normal, as {@code ny} and {@code nz}; the directions along the surface follow T. Duff and others,
     *             Building an orthonormal basis, revisited, 2017
     * @param unit typical distance of the points, scene units; keeps squares of distances in the range of floats
     */
    public void start(float nx, float ny, float nz, float unit) {
        float sign = Math.copySign(1f, nz);
        float a = -1 / (sign + nz);
        float b = nx * ny * a;
        ux = 1 + sign * nx * nx * a;
        uy = sign * b;
        uz = -sign * nx;
        vx = b;
        vy = sign + ny * ny * a;
        vz = -ny;
        inverseUnit = 1 / unit;
        count = 0;
    }

    /**
     * Adds a point.
     *
     * @param w  its weight, ≥ 0
     * @param dx its offset from the place, scene units, as {@code dy} and {@code dz}
     */
    public void add(float w, float dx, float dy, float dz) {
        if (count == weight.length) {
            weight = Arrays.copyOf(weight, 2 * count);
            u = Arrays.copyOf(u, 2 * count);
            v = Arrays.copyOf(v, 2 * count);
        }
        weight[count] = w;
        u[count] = (dx * ux + dy * uy + dz * uz) * inverseUnit;
        v[count++] = (dx * vx + dy * vy + dz * vz) * inverseUnit;
    }

    /** Changes the weights of all points. If the offsets leave the range of floats, they remain. */
    public void adjust() {
        float mu = 0;
        float mv = 0;
        float uu = 0;
        float uv = 0;
        float vv = 0;
        for (int i = 0; i < count; i++) {
            float wu = weight[i] * u[i];
            float wv = weight[i] * v[i];
            mu += wu;
            mv += wv;
            uu += wu * u[i];
            uv += wu * v[i];
            vv += wv * v[i];
        }
        float damping = DAMPING * (uu + vv);
        float a = uu + damping;
        float c = vv + damping;
        float determinant = a * c - uv * uv;
        float su = (uv * mv - c * mu) / determinant;
        float sv = (uv * mu - a * mv) / determinant;
        if (!(Math.abs(su) + Math.abs(sv) < Float.POSITIVE_INFINITY)) {
            return;
        }
        for (int i = 0; i < count; i++) {
            weight[i] *= Math.max(0, 1 + su * u[i] + sv * v[i]);
        }
    }

    /** Returns the number of points. */
    public int count() {
        return count;
    }

    /** Returns the weight of point {@code i}, counted from 0 in the order in which they were added. */
    public float weight(int i) {
        return weight[i];
    }

    /** Returns the largest weight; 0 if there is none. */
    public float largest() {
        float largest = 0;
        for (int i = 0; i < count; i++) {
            largest = Math.max(largest, weight[i]);
        }
        return largest;
    }
}
