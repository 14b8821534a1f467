package lightning.render.shading;

/**
 * How many rays a trace cast, by kind.
 *
 * @param eye      rays through pixels
 * @param mirrored reflected rays
 * @param shadow   rays to lights
 */
public record TraceCounts(long eye, long mirrored, long shadow) {
    public static final TraceCounts NONE = new TraceCounts(0, 0, 0);

    public long all() {
        return eye + mirrored + shadow;
    }

    public TraceCounts plus(TraceCounts o) {
        return new TraceCounts(eye + o.eye, mirrored + o.mirrored, shadow + o.shadow);
    }

    public TraceCounts minus(TraceCounts o) {
        return new TraceCounts(eye - o.eye, mirrored - o.mirrored, shadow - o.shadow);
    }
}
