package lightning.render.cache;

import java.util.function.BiFunction;
import java.util.function.Function;
import lightning.render.image.Film;
import lightning.render.trace.SamplePositions;

/**
 * Anti-aliased tile of the image: its finer samples and the resulting pixels.
 *
 * @param shapes samples of pixels at a geometry edge, or of all pixels; edits of lights keep them
 * @param lights samples of other pixels at a lighting edge: a shadow, a cone, a highlight
 * @param film tile of the film: red, green, blue, {@code float[1024]} each
 */
public record FineTile(FineSamples shapes, FineSamples lights, float[][] film) {

    /**
     * Creates the tile of samples, with their colors, and centers.
     *
     * @param center centers of the tile's pixels, or null if all pixels have several samples
     * @param perPixel number of samples per pixel
     */
    private static FineTile of(CachedTile center, FineSamples shapes, FineSamples lights, int perPixel) {
        FineTile tile = new FineTile(shapes, lights, null);
        return new FineTile(shapes, lights, tile.film(center, t -> t.film, perPixel));
    }

    /** Returns the film of the same samples in other colors, which {@code colors} returns. */
    public float[][] film(CachedTile center, Function<CachedTile, float[][]> colors, int perPixel) {
        float[][] film = new float[3][Film.TILE_PIXELS];
        if (center != null) {
            float[][] centers = colors.apply(center);
            for (int c = 0; c < 3; c++) {
                film[c] = centers[c].clone();
            }
        }
        shapes.write(colors, perPixel, film);
        lights.write(colors, perPixel, film);
        return film;
    }

    /** Returns the same tile without the colors of its samples. */
    public FineTile withoutColors() {
        return new FineTile(shapes.map(CachedTile::withoutColors), lights.map(CachedTile::withoutColors), film);
    }

    /** Returns the tile with changed rows, which then have colors; {@code center} is already changed. */
    public FineTile map(CachedTile center, SamplePositions centers, BiFunction<SamplePositions, CachedTile, CachedTile> change, int grid) {
        return of(center, shapes.map(centers, grid, change), lights.map(centers, grid, change), grid * grid);
    }
}
