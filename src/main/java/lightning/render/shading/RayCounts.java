package lightning.render.shading;

/**
 * Numbers of rays cast by a trace, by kind.
 *
 * @param eye      camera rays
 * @param mirrored bounced rays
 * @param gather   rays of indirect light
 * @param shadow   shadow rays
 */
public record RayCounts(long eye, long mirrored, long gather, long shadow) {
    public static final RayCounts NONE = new RayCounts(0, 0, 0, 0);

    public long total() {
        return eye + mirrored + gather + shadow;
    }

    public RayCounts plus(RayCounts o) {
        return new RayCounts(eye + o.eye, mirrored + o.mirrored, gather + o.gather, shadow + o.shadow);
    }

    public RayCounts minus(RayCounts o) {
        return new RayCounts(eye - o.eye, mirrored - o.mirrored, gather - o.gather, shadow - o.shadow);
    }
}
