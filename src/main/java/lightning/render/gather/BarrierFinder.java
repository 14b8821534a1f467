package lightning.render.gather;

/**
 * Finds the barriers of gather points: surfaces close to a point that separate it from what lies behind them, as a thin wall does. A
 * barrier is a plane that at least one of the point's rays hits within a few radii, as wide as these hits. Holds scratch memory: use one
 * instance per thread.
 */
public final class BarrierFinder {
    /** Largest number of barriers of a point: a corner has two. */
    static final int MAX = 2;
    /** Values of a barrier: its normal, the point's distance from it, and the ends of its width. */
    static final int VALUES = 6;
    /** Length of the rays that find barriers, in radii: the filter reaches 2.7 radii. */
    private static final double REACH = 3;
    /** Smallest cosine between the normals of one barrier: 18°. */
    private static final double SAME_NORMAL = 0.95;
    /** Largest distance between planes of one barrier, in radii. */
    private static final double SAME_PLANE = 0.1;
    /** Smallest sine between a barrier and the surface of its point: a ceiling separates no points of a floor. */
    private static final double MIN_SINE = 0.3;
    /** Distance by which a barrier is wider than its hits, in radii. */
    private static final double MARGIN = 0.25;
    private static final double MIN_COSINE = 1e-3;

    /** Directions of the rays, of length 1. */
    public final double[] dx;
    public final double[] dy;
    public final double[] dz;
    /** Surfel that each ray hits: a place and a normal. */
    public final float[] sx;
    public final float[] sy;
    public final float[] sz;
    public final float[] snx;
    public final float[] sny;
    public final float[] snz;
    /** Whether a ray hits a flat surface. */
    public final boolean[] hit;
    /** Length of each ray and distance of the point from the plane that it hits; the distance is 0 if the ray finds no barrier. */
    private final double[] length;
    private final double[] distance;
    /** Values of the barriers found last. */
    final float[] found = new float[MAX * VALUES];

    /** @param rays of a point */
    public BarrierFinder(int rays) {
        dx = new double[rays];
        dy = new double[rays];
        dz = new double[rays];
        sx = new float[rays];
        sy = new float[rays];
        sz = new float[rays];
        snx = new float[rays];
        sny = new float[rays];
        snz = new float[rays];
        hit = new boolean[rays];
        length = new double[rays];
        distance = new double[rays];
    }

    /**
     * Finds the barriers of a point from its rays and their surfels.
     *
     * @param radius of the point, scene units
     * @return their number
     */
    int find(float px, float py, float pz, float nx, float ny, float nz, float radius) {
        boolean any = false;
        for (int k = 0; k < hit.length; k++) {
            distance[k] = 0;
            if (hit[k]) {
                double height = snx[k] * ((double) px - sx[k]) + sny[k] * ((double) py - sy[k]) + snz[k] * ((double) pz - sz[k]);
                double cosine = -(snx[k] * dx[k] + sny[k] * dy[k] + snz[k] * dz[k]);
                if (height > 0 && cosine > MIN_COSINE && height < REACH * radius * cosine) {
                    distance[k] = height;
                    length[k] = height / cosine;
                    any = true;
                }
            }
        }
        int first = any ? nearest(-1, nx, ny, nz) : -1;
        if (first < 0) {
            return 0;
        }
        write(0, first, nx, ny, nz, radius);
        int second = nearest(first, nx, ny, nz);
        if (second < 0) {
            return 1;
        }
        write(1, second, nx, ny, nz, radius);
        return 2;
    }

    /**
     * Returns the ray that hits the plane nearest to the point; −1 for none.
     *
     * @param other ray whose plane does not count, nor others of similar normals; −1 for none
     */
    private int nearest(int other, float nx, float ny, float nz) {
        int nearest = -1;
        for (int k = 0; k < hit.length; k++) {
            if (distance[k] > 0 && (nearest < 0 || distance[k] < distance[nearest]) && (other < 0 || !hasSameNormal(k, other))
                    && sineSquare(k, nx, ny, nz) > MIN_SINE * MIN_SINE) {
                nearest = k;
            }
        }
        return nearest;
    }

    private boolean hasSameNormal(int k, int other) {
        return (double) snx[k] * snx[other] + (double) sny[k] * sny[other] + (double) snz[k] * snz[other] >= SAME_NORMAL;
    }

    private double sineSquare(int k, float nx, float ny, float nz) {
        double x = alongX(sny[k], snz[k], ny, nz);
        double y = alongX(snz[k], snx[k], nz, nx);
        double z = alongX(snx[k], sny[k], nx, ny);
        return x * x + y * y + z * z;
    }

    /** Returns a component of the direction in which a barrier is wide: the cross product of its normal and that of its point. */
    static double alongX(float by, float bz, float ny, float nz) {
        return (double) by * nz - (double) bz * ny;
    }

    private void write(int barrier, int ray, float nx, float ny, float nz, float radius) {
        double x = alongX(sny[ray], snz[ray], ny, nz);
        double y = alongX(snz[ray], snx[ray], nz, nx);
        double z = alongX(snx[ray], sny[ray], nx, ny);
        double least = Double.POSITIVE_INFINITY;
        double greatest = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < hit.length; k++) {
            double apart = snx[ray] * ((double) sx[k] - sx[ray]) + sny[ray] * ((double) sy[k] - sy[ray])
                    + snz[ray] * ((double) sz[k] - sz[ray]);
            if (distance[k] > 0 && hasSameNormal(k, ray) && Math.abs(apart) < SAME_PLANE * radius) {
                double at = length[k] * (dx[k] * x + dy[k] * y + dz[k] * z);
                least = Math.min(least, at);
                greatest = Math.max(greatest, at);
            }
        }
        double margin = MARGIN * radius * Math.sqrt(x * x + y * y + z * z);
        int to = barrier * VALUES;
        found[to] = snx[ray];
        found[to + 1] = sny[ray];
        found[to + 2] = snz[ray];
        found[to + 3] = (float) distance[ray];
        found[to + 4] = (float) (least - margin);
        found[to + 5] = (float) (greatest + margin);
    }
}
