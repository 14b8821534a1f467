package lightning.document.loop;

import lightning.scene.AntialiasMode;
import lightning.scene.GatherSettings;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;

/**
 * Resolutions of the coarse images that precede a full one, chosen by the rate at which the last one was traced. The first has so few
 * pixels that it is soon complete even if rays are slow or the code is not compiled yet.
 *
 * @param pixels  pixels of the full image
 * @param samples its samples, before edges are refined
 * @param minSamplesPerPixel minimum ratio of samples in the full image to pixels in a coarse one. Below it, tracing the coarse image
 *     takes too large a share
 */
record CoarseSteps(double pixels, double samples, int minSamplesPerPixel) {
    private static final int FIRST_PIXELS = 250;
    /** Minimum ratio of samples to pixels of a coarse image for full images with direct light alone, and with gathered light. */
    private static final int SAMPLES_PER_DIRECT_PIXEL = 32;
    private static final int SAMPLES_PER_GATHERED_PIXEL = 4;
    /** Minimum ratio for any coarse image. Below it, the full image is ready too soon for a preview. */
    private static final int MIN_SAMPLES_PER_FIRST_PIXEL = 128;
    /** Growth from one coarse image to the next if rays are slow. */
    private static final double GROWTH = 4;
    /** Minimum growth. A smaller one would hardly be visible. */
    private static final double MIN_GROWTH = 2.5;
    /** Time for each coarse image unless it would grow too little, in seconds. */
    private static final double STEP_SECONDS = 0.12;
    /** A full image that takes less than this needs no further coarse one, in seconds. */
    private static final double SHORT_SECONDS = 0.25;

    static CoarseSteps of(Scene scene) {
        PictureSettings picture = scene.picture();
        SamplingSettings sampling = picture.sampling();
        double pixels = (double) picture.width() * picture.height();
        return new CoarseSteps(pixels, pixels * (sampling.antialias() == AntialiasMode.EVERY ? sampling.samplesPerPixel() : 1),
                GatherSettings.of(scene).isPresent() ? SAMPLES_PER_GATHERED_PIXEL : SAMPLES_PER_DIRECT_PIXEL);
    }

    /** Returns the pixels of the first coarse image; 0 if the full image is ready as soon. */
    int first() {
        return samples / FIRST_PIXELS < MIN_SAMPLES_PER_FIRST_PIXEL ? 0 : FIRST_PIXELS;
    }

    /**
     * Returns the pixels of the next coarse image; 0 if the full image is next.
     *
     * @param shown   pixels of the last coarse image
     * @param perSecond pixels that were traced per second
     */
    int next(int shown, double perSecond) {
        if (samples < perSecond * SHORT_SECONDS) {
            return 0;
        }
        double next = Math.min(maxPixels(), Math.max(shown * GROWTH, perSecond * STEP_SECONDS));
        return next < shown * MIN_GROWTH ? 0 : (int) next;
    }

    /**
     * Returns the pixels of the next coarse image; 0 if the full image is next, or if the coarse one would take longer than a time.
     *
     * @param seconds time
     */
    int nextWithin(int shown, double perSecond, double seconds) {
        int next = next(shown, perSecond);
        return next < seconds * perSecond ? next : 0;
    }

    /** Returns the pixels of a coarse image that is traced in a given time; at least those of the first. */
    int during(double seconds, double perSecond) {
        return (int) Math.clamp(perSecond * seconds, FIRST_PIXELS, Math.max(FIRST_PIXELS, maxPixels()));
    }

    private double maxPixels() {
        return Math.min(pixels, samples / minSamplesPerPixel);
    }
}
