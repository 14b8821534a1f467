package lightning.render.gather.point;

/**
 * Finds the barriers of gather points: surfaces close to a point that separate it from places behind them, as a thin wall does. A
 * barrier is a plane that at least one of the point's rays hits within a few radii, as wide as these hits. Holds scratch memory: use one
 * instance per thread.
 */
public final class BarrierFinder {
    /** Largest number of barriers of a point: a corner has two. */
    static final int MAX = 3;
    /** Planes among which those with the most hits are chosen: a wall beside a ball, whose hits lie on many planes. */
    private static final int MAX_PLANES = 8;
    /** Values of a barrier: its normal, the point's distance from it, and the ends of its width. */
    static final int VALUES = 6;
    /** Length of the rays that find barriers, in radii: the filter reaches 4 radii. */
    private static final double REACH = 5;
    /** Smallest cosine between the normals of one barrier: 18°. */
    private static final double SAME_NORMAL = 0.95;
    /** Largest distance between planes of one barrier, in radii. */
    private static final double SAME_PLANE = 0.1;
    /** Smallest sine between a barrier and the surface of its point: a ceiling separates no points of a floor. */
    private static final double MIN_SINE = 0.3;
    /** Distance by which a barrier is wider than a single hit, in radii; less for more hits, which find its ends. */
    private static final double MARGIN = 1;
    private static final double MIN_COSINE = 1e-3;

    /** Directions of the rays, of length 1. */
    public final double[] dx;
    public final double[] dy;
    public final double[] dz;
    /** Surfel that each ray hits: a place and a normal. */
    private final float[] sx;
    private final float[] sy;
    private final float[] sz;
    private final float[] snx;
    private final float[] sny;
    private final float[] snz;
    private final boolean[] hit;
    /** Length of each ray and distance of the point from the plane that it hits; the distance is 0 if the ray finds no barrier. */
    private final double[] length;
    private final double[] distance;
    /** A ray that hits each plane, and the number of rays that do. */
    private final int[] planeRay = new int[MAX_PLANES];
    private final int[] planeHits = new int[MAX_PLANES];
    private int planes;
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

    /** Sets that a ray hits no surface that can be a barrier. */
    public void setMiss(int k) {
        hit[k] = false;
    }

    /**
     * Sets the surfel that a ray hits.
     *
     * @param x  place, render space, with {@code y} and {@code z}
     * @param nx unit normal, facing the ray, with {@code ny} and {@code nz}
     */
    public void setHit(int k, float x, float y, float z, float nx, float ny, float nz) {
        hit[k] = true;
        sx[k] = x;
        sy[k] = y;
        sz[k] = z;
        snx[k] = nx;
        sny[k] = ny;
        snz[k] = nz;
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
        planes = 0;
        for (int k = 0; any && k < hit.length; k++) {
            if (distance[k] > 0) {
                addToPlane(k, nx, ny, nz, radius);
            }
        }
        int count = 0;
        for (int plane = mostHits(); plane >= 0 && count < MAX; plane = mostHits()) {
            write(count++, planeRay[plane], nx, ny, nz, radius);
            planeHits[plane] = 0;
        }
        return count;
    }

    /** Counts a hit for its plane, or for a new one if there are not too many. */
    private void addToPlane(int k, float nx, float ny, float nz, float radius) {
        for (int plane = 0; plane < planes; plane++) {
            if (isOnPlane(k, planeRay[plane], radius)) {
                planeHits[plane]++;
                return;
            }
        }
        if (planes < MAX_PLANES && sineSquare(k, nx, ny, nz) > MIN_SINE * MIN_SINE) {
            planeRay[planes] = k;
            planeHits[planes++] = 1;
        }
    }

    /** Returns the plane with the most hits, the first of equals; −1 if none has any. */
    private int mostHits() {
        int most = -1;
        for (int plane = 0; plane < planes; plane++) {
            if (planeHits[plane] > (most < 0 ? 0 : planeHits[most])) {
                most = plane;
            }
        }
        return most;
    }

    private boolean isOnPlane(int k, int ray, float radius) {
        double apart =
                snx[ray] * ((double) sx[k] - sx[ray]) + sny[ray] * ((double) sy[k] - sy[ray]) + snz[ray] * ((double) sz[k] - sz[ray]);
        return hasSameNormal(k, ray) && Math.abs(apart) < SAME_PLANE * radius;
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
        int hits = 0;
        for (int k = 0; k < hit.length; k++) {
            if (distance[k] > 0 && isOnPlane(k, ray, radius)) {
                double at = length[k] * (dx[k] * x + dy[k] * y + dz[k] * z);
                least = Math.min(least, at);
                greatest = Math.max(greatest, at);
                hits++;
            }
        }
        double margin = MARGIN * radius * Math.sqrt((x * x + y * y + z * z) / hits);
        int to = barrier * VALUES;
        found[to] = snx[ray];
        found[to + 1] = sny[ray];
        found[to + 2] = snz[ray];
        found[to + 3] = (float) distance[ray];
        found[to + 4] = (float) (least - margin);
        found[to + 5] = (float) (greatest + margin);
    }
}
