package lightning.scene;

import lightning.scene.value.SceneLimits;

/**
 * Sampling of an image. A pixel with several samples is the mean of a regular grid of them.
 *
 * @param antialias pixels that have several samples
 * @param grid      samples along each side of such a pixel, 2 to 8; kept without effect if no pixel has several
 */
public record SamplingSettings(AntialiasMode antialias, int grid) {
    public static final SamplingSettings DEFAULT = new SamplingSettings(AntialiasMode.OFF, 4);
    /** All samples of a pixel together cast at least this many times the shadow rays of its center to an area light. */
    private static final int LIGHT_SAMPLES_SHARE = 2;

    public SamplingSettings {
        SceneLimits.checkRange("samples", grid, SceneLimits.MIN_SAMPLES, SceneLimits.MAX_SAMPLES);
    }

    /** Returns whether any pixel may have several samples. */
    public boolean isSupersampled() {
        return antialias != AntialiasMode.OFF;
    }

    /** Returns the samples of a pixel with several. */
    public int samplesPerPixel() {
        return grid * grid;
    }

    /**
     * Returns how many samples of an area light each sample of a pixel with several uses.
     *
     * @param light samples of the light from the pixel's center
     */
    public int lightSamples(int light) {
        return Math.ceilDiv(LIGHT_SAMPLES_SHARE * light, samplesPerPixel());
    }

    /** Returns whether both settings place the same samples, whatever the scene. */
    public boolean hasSameSamples(SamplingSettings o) {
        return antialias == o.antialias && (!isSupersampled() || grid == o.grid);
    }
}
