package lightning.render.gather;

import lightning.render.trace.HitRows;

/**
 * Paths of diffuse indirect light: from surfels to surfels to gather points to rows. Determined by shapes, camera and settings alone.
 * Immutable.
 *
 * <p>A surfel is a small part of a surface. It is lit at one place, its row, like every other row.
 */
public final class GatherStructure {
    private final GatherPoints points;
    private final RayLinks pointLinks;
    private final RayLinks surfelLinks;
    private final HitRows[] surfels;
    private final int[] blockStart;
    private final int surfelCount;
    private final int bounces;
    private final long rays;

    GatherStructure(GatherPoints points, RayLinks pointLinks, RayLinks surfelLinks, HitRows[] surfels, int[] blockStart,
            int surfelCount, int bounces, long rays) {
        this.points = points;
        this.pointLinks = pointLinks;
        this.surfelLinks = surfelLinks;
        this.surfels = surfels;
        this.blockStart = blockStart;
        this.surfelCount = surfelCount;
        this.bounces = bounces;
        this.rays = rays;
    }

    GatherPoints points() {
        return points;
    }

    public int pointCount() {
        return points.count();
    }

    public int surfelCount() {
        return surfelCount;
    }

    /** Returns the diffuse bounces between a light and a gather point. */
    public int bounces() {
        return bounces;
    }

    /** Returns the rows of the surfels in blocks of at most 1024; {@code parent} is the surfel's position in the block. */
    public HitRows[] surfels() {
        return surfels.clone();
    }

    /** Returns the number of a block's first surfel. */
    public int firstSurfel(int block) {
        return blockStart[block];
    }

    /** Returns the surfels that the rays of gather points hit. */
    public RayLinks pointLinks() {
        return pointLinks;
    }

    /** Returns the surfels that the rays of the first surfels hit; later surfels have no rays. */
    public RayLinks surfelLinks() {
        return surfelLinks;
    }

    /** Writes the means over neighboring gather points {@code first … end − 1}. */
    public void filter(float[] from, float[] to, int first, int end) {
        points.filter().apply(from, to, first, end);
    }

    /** Returns the rays that were cast to build it. */
    public long rays() {
        return rays;
    }

    /** Returns the bytes of all columns. */
    public long bytes() {
        return pointBytes() + surfelBytes();
    }

    /** Returns the bytes of the gather points, their filter and their links. */
    public long pointBytes() {
        return pointLinks.bytes() + points.filter().bytes() + 32L * points.count();
    }

    /** Returns the bytes that it took at most while it was built. */
    public long buildBytes() {
        return bytes() + RayLinks.BUILD_BYTES * ((long) pointLinks.surfels().length + surfelLinks.surfels().length);
    }

    /** Returns the share of gather points, their filter and their links in these bytes. */
    public long pointBuildBytes() {
        return pointBytes() + RayLinks.BUILD_BYTES * (long) pointLinks.surfels().length;
    }

    private long surfelBytes() {
        long bytes = surfelLinks.bytes();
        for (HitRows rows : surfels) {
            bytes += rows.bytes();
        }
        return bytes;
    }
}
