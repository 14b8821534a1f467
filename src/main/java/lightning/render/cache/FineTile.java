package lightning.render.cache;

import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.stream.Stream;
import lightning.render.image.Film;
import lightning.render.shading.SampleMean;
import lightning.render.trace.SamplePositions;
import org.jspecify.annotations.Nullable;

/**
 * Anti-aliased tile of the image: its finer samples and the resulting pixels.
 *
 * @param first samples of the pixels at an edge, or of all pixels
 * @param rest  further samples of those of these pixels whose first samples differ visibly
 * @param film  tile of the film: red, green, blue, {@code float[1024]} each
 */
public record FineTile(FineSamples first, FineSamples rest, float @Nullable [][] film) {

    /**
     * Creates the tile of samples and centers.
     *
     * @param center colors of the tile's pixel centers; null if all pixels have several samples
     */
    public static FineTile of(float @Nullable [][] center, FineSamples first, FineSamples rest) {
        return new FineTile(first, rest, film(center, first, SampleBlock::means, rest, SampleBlock::means));
    }

    private static float[][] film(float @Nullable [][] center, FineSamples first, Function<SampleBlock, float[][]> firstMeans,
            FineSamples rest, Function<SampleBlock, float[][]> restMeans) {
        float[][] film = center == null ? new float[3][Film.TILE_PIXELS]
                : new float[][] {center[0].clone(), center[1].clone(), center[2].clone()};
        first.forEachMean(firstMeans, (pixel, red, green, blue) -> {
            film[0][pixel] = red;
            film[1][pixel] = green;
            film[2][pixel] = blue;
        });
        int count = first.cells().count();
        int restCount = rest.cells().count();
        rest.forEachMean(restMeans, (pixel, red, green, blue) -> {
            film[0][pixel] = SampleMean.combine(film[0][pixel], count, red, restCount);
            film[1][pixel] = SampleMean.combine(film[1][pixel], count, green, restCount);
            film[2][pixel] = SampleMean.combine(film[2][pixel], count, blue, restCount);
        });
        return film;
    }

    /**
     * Returns the film of the same samples in other colors.
     *
     * @param center rows of the pixel centers, or null if all pixels have several samples
     * @param colors returns the colors of rows
     */
    public float[][] film(@Nullable CachedTile center, Function<CachedTile, float[][]> colors) {
        return film(center == null ? null : colors.apply(center), first, block -> first.means(block, colors.apply(block.rows())), rest,
                block -> rest.means(block, colors.apply(block.rows())));
    }

    /** Returns all samples. */
    public List<FineSamples> stages() {
        return List.of(first, rest);
    }

    /** Returns all blocks of samples. */
    public Stream<SampleBlock> blocks() {
        return stages().stream().flatMap(samples -> Stream.of(samples.blocks()));
    }

    /** Returns the same tile without the colors of single samples. */
    public FineTile withoutColors() {
        return new FineTile(first.withoutColors(), rest.withoutColors(), film);
    }

    /**
     * Returns the tile with changed rows, which then have colors.
     *
     * @param center  the changed rows of the pixel centers
     * @param centers positions of the tile
     */
    public FineTile map(@Nullable CachedTile center, SamplePositions centers, BiFunction<SamplePositions, CachedTile, CachedTile> change) {
        return of(center == null ? null : center.film, first.map(centers, change), rest.map(centers, change));
    }
}
