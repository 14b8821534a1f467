package lightning.render.gather;

import java.util.Arrays;

/** Surfels that the rays of points hit, by ray. First they are known by the keys of their cells, later by their numbers. */
public final class RayLinks {
    /** Number of a ray that hits nothing. */
    public static final int MISS = -1;
    /** Bytes of a ray only while links are built: a key and a flag, half as many in reserve, and a copy of the key while they grow. */
    public static final int BUILD_BYTES = 22;

    private final int raysPerPoint;
    private int rays;
    private long[] keys = {};
    private boolean[] hit = {};
    /** Surfel of each ray, {@link #MISS} for none. */
    private int[] surfel = {};
    /** Tint of each ray: red, green, blue; null if none is tinted. */
    private float[][] tint;

    RayLinks(int raysPerPoint) {
        this.raysPerPoint = raysPerPoint;
    }

    /** Makes room for the rays of {@code points} points. */
    void setPoints(int points) {
        rays = Math.multiplyExact(points, raysPerPoint);
        if (rays > keys.length) {
            int length = (int) Math.min(Integer.MAX_VALUE - 64, Math.max(rays, keys.length * 3L / 2));
            keys = Arrays.copyOf(keys, length);
            hit = Arrays.copyOf(hit, length);
            for (int c = 0; tint != null && c < 3; c++) {
                int known = tint[c].length;
                tint[c] = Arrays.copyOf(tint[c], length);
                Arrays.fill(tint[c], known, length, 1);
            }
        }
    }

    void clear(int from, int to) {
        Arrays.fill(hit, from, to, false);
    }

    void setKey(int ray, long key) {
        keys[ray] = key;
        hit[ray] = true;
    }

    /** Sets the tints of rays {@code from … from + count − 1}. */
    void setTints(int from, int count, float[][] tints) {
        float[][] all = allocateTints();
        for (int c = 0; c < 3; c++) {
            System.arraycopy(tints[c], 0, all[c], from, count);
        }
    }

    /** Sets the tint of a ray to element {@code from} of some tints. */
    void setTint(int ray, float[][] tints, int from) {
        float[][] all = allocateTints();
        for (int c = 0; c < 3; c++) {
            all[c][ray] = tints[c][from];
        }
    }

    private synchronized float[][] allocateTints() {
        if (tint == null) {
            float[][] all = new float[3][keys.length];
            for (float[] channel : all) {
                Arrays.fill(channel, 1);
            }
            tint = all;
        }
        return tint;
    }

    boolean isHit(int ray) {
        return hit[ray];
    }

    long key(int ray) {
        return keys[ray];
    }

    int rayCount() {
        return rays;
    }

    /** Replaces keys by the numbers of the cells. */
    void resolve(CellTable cells, int from, int to) {
        for (int ray = from; ray < to; ray++) {
            surfel[ray] = hit[ray] ? cells.number(keys[ray]) : MISS;
        }
    }

    void allocateNumbers() {
        surfel = Arrays.copyOf(surfel, rays);
    }

    /** Drops what only building needs. */
    void finish() {
        keys = new long[0];
        hit = new boolean[0];
        for (int c = 0; tint != null && c < 3; c++) {
            tint[c] = Arrays.copyOf(tint[c], rays);
        }
    }

    /** Returns the number of points. */
    public int points() {
        return rays / raysPerPoint;
    }

    public int raysPerPoint() {
        return raysPerPoint;
    }

    /** Returns the surfel of each ray, point by point; {@link #MISS} for none. Callers must not modify it. */
    public int[] surfels() {
        return surfel;
    }

    /** Returns the tints of all rays: red, green, blue; null if none is tinted. Callers must not modify them. */
    public float[][] tints() {
        return tint;
    }

    /** Returns the bytes of the links. */
    public long bytes() {
        return 4L * surfel.length + (tint == null ? 0 : 12L * tint[0].length);
    }
}
