package lightning.scene;

/**
 * How a picture is sampled. A pixel with several samples is the mean of a regular grid of them.
 *
 * @param antialias which pixels have several samples
 * @param grid      samples along each side of such a pixel, 2 to 8; kept, without effect, where there are none
 */
public record Sampling(Antialias antialias, int grid) {
    public static final Sampling DEFAULT = new Sampling(Antialias.OFF, 4);

    public Sampling {
        Limits.range("samples", grid, Limits.MIN_SAMPLES, Limits.MAX_SAMPLES);
    }

    /** Whether any pixel may have several samples. */
    public boolean isFine() {
        return antialias != Antialias.OFF;
    }

    /** The samples of a pixel that has several. */
    public int perPixel() {
        return grid * grid;
    }

    /** Whether a picture sampled in this way has the same samples, whatever the scene. */
    public boolean samplesLike(Sampling o) {
        return antialias == o.antialias && (!isFine() || grid == o.grid);
    }
}
