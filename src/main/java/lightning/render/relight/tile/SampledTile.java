package lightning.render.relight.tile;

import lightning.render.cache.CachedTile;
import lightning.render.cache.FineTile;
import lightning.render.image.Film;
import lightning.render.shading.SampleMean;

/**
 * A tile's pixels while its finer samples are made: those of new samples are written, those of samples that stay are taken over, and
 * where nothing is written the film before stays as it is.
 */
final class SampledTile {
    private final float[][] previous;
    private final int perPixel;
    private final boolean startsFromCenters;
    /** Null while it is the one before. */
    private float[][] film;

    private SampledTile(float[][] known, float[][] film, int perPixel) {
        this.previous = known;
        this.film = film;
        this.perPixel = perPixel;
        startsFromCenters = film != null;
    }

    /** Goes on from the film before, of which all holds that is not written. */
    static SampledTile ofPrevious(FineTile old, int perPixel) {
        return new SampledTile(old.film(), null, perPixel);
    }

    /**
     * Begins with the centers.
     *
     * @param center null where all pixels have several samples
     * @param old    what samples that stay made before, or null
     */
    static SampledTile ofCenters(CachedTile center, FineTile old, int perPixel) {
        float[][] film = center == null ? new float[3][Film.TILE_PIXELS] : copy(center.film);
        return new SampledTile(old == null ? null : old.film(), film, perPixel);
    }

    private static float[][] copy(float[][] film) {
        return new float[][] {film[0].clone(), film[1].clone(), film[2].clone()};
    }

    /** The samples of some pixels are in the colors of before. */
    void copyPrevious(short[] pixels, int from, int to) {
        if (startsFromCenters) {
            for (int c = 0; c < 3; c++) {
                for (int i = from; i < to; i++) {
                    film[c][pixels[i]] = previous[c][pixels[i]];
                }
            }
        }
    }

    /** The samples of some pixels have these colors. */
    void write(short[] pixels, int from, int to, float[][] samples) {
        if (film == null) {
            film = copy(previous);
        }
        SampleMean.write(pixels, from, to, perPixel, samples, film);
    }

    /** Red, green and blue; the arrays of before where nothing was written. */
    float[][] film() {
        return film == null ? previous : film;
    }
}
