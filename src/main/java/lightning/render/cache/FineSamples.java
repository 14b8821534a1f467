package lightning.render.cache;

import java.util.Arrays;
import java.util.function.BiFunction;
import java.util.function.Function;
import lightning.render.shading.SampleMean;
import lightning.render.trace.SamplePlaces;

/**
 * The samples of some pixels of a tile.
 *
 * @param pixels the pixels' indices in the tile, ascending
 * @param blocks the samples, those of as many pixels in each block as have room in 1024 rows
 */
public record FineSamples(short[] pixels, CachedTile[] blocks) {
    // Arrays in a record: written once by their maker, never after.

    /** Makes the pixels of their samples, whose colours {@code colors} tells for each block. */
    void write(Function<CachedTile, float[][]> colors, int perPixel, float[][] film) {
        int together = SampleMean.pixelsTogether(perPixel);
        for (int b = 0; b < blocks.length; b++) {
            int to = Math.min(pixels.length, (b + 1) * together);
            SampleMean.write(pixels, b * together, to, perPixel, colors.apply(blocks[b]), film);
        }
    }

    /** The same samples with other blocks, each made of where its rays go and what it was; {@code centers} are those of the tile. */
    FineSamples map(SamplePlaces centers, int grid, BiFunction<SamplePlaces, CachedTile, CachedTile> change) {
        int together = SampleMean.pixelsTogether(grid * grid);
        CachedTile[] changed = new CachedTile[blocks.length];
        for (int b = 0; b < blocks.length; b++) {
            int to = Math.min(pixels.length, (b + 1) * together);
            changed[b] = change.apply(new SamplePlaces(centers.x0(), centers.y0(), pixels, b * together, to, grid), blocks[b]);
        }
        return new FineSamples(pixels, changed);
    }

    /** The same samples with other blocks. */
    FineSamples map(Function<CachedTile, CachedTile> change) {
        return new FineSamples(pixels, Arrays.stream(blocks).map(change).toArray(CachedTile[]::new));
    }
}
