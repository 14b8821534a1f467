package lightning.render.cache;

import java.util.function.BiFunction;
import java.util.function.Function;
import lightning.render.image.Film;
import lightning.render.trace.SamplePositions;

/**
 * The finer samples of one tile of the picture (anti-aliasing), and the pixels that they make together with the centers.
 *
 * @param shapes samples of pixels at an edge of what is hit, or of all pixels; they stay while lights are edited
 * @param lights samples of the other pixels at an edge of a light: a shadow, a cone, a highlight
 * @param film   the tile of the film: red, green, blue, {@code float[1024]} each
 */
public record FineTile(FineSamples shapes, FineSamples lights, float[][] film) {

    /**
     * The tile that samples, which have their colors, and centers make.
     *
     * @param center   the centers of the tile's pixels, or null where all have several samples
     * @param perPixel how many samples
     */
    private static FineTile of(CachedTile center, FineSamples shapes, FineSamples lights, int perPixel) {
        FineTile tile = new FineTile(shapes, lights, null);
        return new FineTile(shapes, lights, tile.film(center, t -> t.film, perPixel));
    }

    /** The film that the same samples make in other colors, which {@code colors} tells. */
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

    /** The same tile, whose samples keep no colors. */
    public FineTile withoutColors() {
        return new FineTile(shapes.map(CachedTile::withoutColors), lights.map(CachedTile::withoutColors), film);
    }

    /** The same tile with its rows changed, which have colors then; {@code center} is changed already. */
    public FineTile map(CachedTile center, SamplePositions centers, BiFunction<SamplePositions, CachedTile, CachedTile> change, int grid) {
        return of(center, shapes.map(centers, grid, change), lights.map(centers, grid, change), grid * grid);
    }
}
