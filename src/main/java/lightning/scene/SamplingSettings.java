package lightning.scene;

/**
 * How a picture is sampled. A pixel with several samples is the mean of a regular grid of them.
 *
 * @param antialias which pixels have several samples
 * @param grid      samples along each side of such a pixel, 2 to 8; kept, without effect, where there are none
 */
public record SamplingSettings(AntialiasMode antialias, int grid) {
    public static final SamplingSettings DEFAULT = new SamplingSettings(AntialiasMode.OFF, 4);

    public SamplingSettings {
        SceneLimits.checkRange("samples", grid, SceneLimits.MIN_SAMPLES, SceneLimits.MAX_SAMPLES);
    }

    /** Whether any pixel may have several samples. */
    public boolean isSupersampled() {
        return antialias != AntialiasMode.OFF;
    }

    /** The samples of a pixel that has several. */
    public int samplesPerPixel() {
        return grid * grid;
    }

    /** Whether a picture sampled in this way has the same samples, whatever the scene. */
    public boolean hasSameSamples(SamplingSettings o) {
        return antialias == o.antialias && (!isSupersampled() || grid == o.grid);
    }
}
