package lightning.render.warmup;

import lightning.scene.AntialiasMode;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;

/**
 * Which pictures take a process that has just started so long that the second compiler and the lanes are worth their start:
 * docs/decisions/0120-a-picture-by-a-lighter-java.md tells from where on they are.
 */
public final class LongRenderCheck {
    private static final long MIN_RAYS = 100_000_000;

    private LongRenderCheck() {}

    /** @param scene as the view shows it */
    public static boolean isLong(Scene scene) {
        return estimateRays(scene) >= MIN_RAYS;
    }

    /** About the eye rays and ways to lights, were there something in each pixel that faces every light; without mirrored and refracted rays. */
    static long estimateRays(Scene scene) {
        PictureSettings picture = scene.picture();
        long samples = picture.sampling().antialias() == AntialiasMode.OFF ? 1 : picture.sampling().samplesPerPixel();
        long shadowRays = scene.rig().effectiveLights().stream().mapToLong(light -> light.isArea() ? light.area().samples() : 1).sum();
        return (long) picture.width() * picture.height() * samples * (1 + shadowRays);
    }
}
