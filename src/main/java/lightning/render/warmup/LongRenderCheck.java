package lightning.render.warmup;

import lightning.scene.AntialiasMode;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;

/**
 * Estimate of whether an image takes a new process long enough for the second compiler and the lanes to pay off. For the
 * threshold see docs/decisions/0120-single-images-with-a-smaller-java.md.
 */
public final class LongRenderCheck {
    private static final long MIN_RAYS = 100_000_000;

    private LongRenderCheck() {}

    /** @param scene scene as the view shows it */
    public static boolean isLong(Scene scene) {
        return estimateRays(scene) >= MIN_RAYS;
    }

    /**
     * Estimates the number of camera rays and shadow rays, as if a surface in each pixel faced every light; without reflected
     * and refracted rays.
     */
    static long estimateRays(Scene scene) {
        PictureSettings picture = scene.picture();
        long samples = picture.sampling().antialias() == AntialiasMode.OFF ? 1 : picture.sampling().samplesPerPixel();
        long shadowRays = scene.rig().effectiveLights().stream().mapToLong(light -> light.isArea() ? light.area().samples() : 1).sum();
        return (long) picture.width() * picture.height() * samples * (1 + shadowRays);
    }
}
