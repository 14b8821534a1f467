package lightning.scene;

/**
 * Diffuse indirect light of an image: light that surfaces pass on to other surfaces.
 *
 * @param bounces    diffuse bounces between a light and the surface that is seen, 1 to 8
 * @param rays       rays by which a gather point collects light: 16, 64, 256 or 1024
 * @param spacing    distance of gather points on open surfaces, pixels, 2 to 64
 * @param background true if the background lights the scene where a ray leaves it
 */
public record IndirectSettings(int bounces, int rays, int spacing, boolean background) {
    public static final int MAX_BOUNCES = 8;
    public static final int MIN_SPACING = 2;
    public static final int MAX_SPACING = 64;
    public static final IndirectSettings DEFAULT = new IndirectSettings(2, 64, 8, false);

    public IndirectSettings {
        SceneLimits.checkRange("indirect: bounces", bounces, 1, MAX_BOUNCES);
        if (rays != 16 && rays != 64 && rays != 256 && rays != 1024) {
            throw new IllegalArgumentException("indirect: rays must be 16, 64, 256 or 1024, was " + rays);
        }
        SceneLimits.checkRange("indirect: spacing", spacing, MIN_SPACING, MAX_SPACING);
    }

    /** Returns the rays along each side of the square pattern of a gather point: the square root of {@link #rays}. */
    public int raysPerSide() {
        return (int) Math.round(Math.sqrt(rays));
    }
}
