package lightning.render.shading;

/**
 * How many rays a trace cast, by kind.
 *
 * @param eye      rays through pixels
 * @param mirrored reflected rays
 * @param shadow   rays to lights
 */
public record RayCounts(long eye, long mirrored, long shadow) {
    public static final RayCounts NONE = new RayCounts(0, 0, 0);

    public long total() {
        return eye + mirrored + shadow;
    }

    public RayCounts plus(RayCounts o) {
        return new RayCounts(eye + o.eye, mirrored + o.mirrored, shadow + o.shadow);
    }

    public RayCounts minus(RayCounts o) {
        return new RayCounts(eye - o.eye, mirrored - o.mirrored, shadow - o.shadow);
    }
}
