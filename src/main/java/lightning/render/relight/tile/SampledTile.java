package lightning.render.relight.tile;

import lightning.render.cache.CachedTile;
import lightning.render.cache.FineTile;
import lightning.render.image.Film;
import lightning.render.shading.SampleMean;

/**
 * Pixels of a tile while its finer samples are built. New samples are written, unchanged samples are copied, and pixels that are
 * not written keep the previous film.
 */
final class SampledTile {
    private final float[][] previous;
    private final int perPixel;
    private final boolean startsFromCenters;
    /** Null while it equals the previous one. */
    private float[][] film;

    private SampledTile(float[][] known, float[][] film, int perPixel) {
        this.previous = known;
        this.film = film;
        this.perPixel = perPixel;
        startsFromCenters = film != null;
    }

    /** Starts with the previous film, whose unwritten pixels stay valid. */
    static SampledTile ofPrevious(FineTile old, int perPixel) {
        return new SampledTile(old.film(), null, perPixel);
    }

    /**
     * Starts with the centers.
     *
     * @param center null if all pixels have several samples
     * @param old    previous tile, from which unchanged samples are copied, or null
     */
    static SampledTile ofCenters(CachedTile center, FineTile old, int perPixel) {
        float[][] film = center == null ? new float[3][Film.TILE_PIXELS] : copy(center.film);
        return new SampledTile(old == null ? null : old.film(), film, perPixel);
    }

    private static float[][] copy(float[][] film) {
        return new float[][] {film[0].clone(), film[1].clone(), film[2].clone()};
    }

    /** Copies the previous colors of some pixels. */
    void copyPrevious(short[] pixels, int from, int to) {
        if (startsFromCenters) {
            for (int c = 0; c < 3; c++) {
                for (int i = from; i < to; i++) {
                    film[c][pixels[i]] = previous[c][pixels[i]];
                }
            }
        }
    }

    /** Writes the colors of some pixels' samples. */
    void write(short[] pixels, int from, int to, float[][] samples) {
        if (film == null) {
            film = copy(previous);
        }
        SampleMean.write(pixels, from, to, perPixel, samples, film);
    }

    /** Returns red, green and blue; the previous arrays if nothing was written. */
    float[][] film() {
        return film == null ? previous : film;
    }
}
