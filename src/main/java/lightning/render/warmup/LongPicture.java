package lightning.render.warmup;

import lightning.scene.Antialias;
import lightning.scene.Picture;
import lightning.scene.Scene;

/**
 * Which pictures take a process that has just started so long that the second compiler and the lanes are worth their start:
 * docs/decisions/0120-a-picture-by-a-lighter-java.md tells from where on they are.
 */
public final class LongPicture {
    private static final long FEWEST_RAYS = 100_000_000;

    private LongPicture() {}

    /** @param scene as the view shows it */
    public static boolean is(Scene scene) {
        return rays(scene) >= FEWEST_RAYS;
    }

    /** About the eye rays and ways to lights, were there something in each pixel that faces every light; without mirrored and refracted rays. */
    static long rays(Scene scene) {
        Picture picture = scene.picture();
        long samples = picture.sampling().antialias() == Antialias.OFF ? 1 : picture.sampling().perPixel();
        long ways = scene.rig().actingLights().stream().mapToLong(light -> light.isArea() ? light.area().samples() : 1).sum();
        return (long) picture.width() * picture.height() * samples * (1 + ways);
    }
}
