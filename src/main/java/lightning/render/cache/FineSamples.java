package lightning.render.cache;

import java.util.Arrays;
import java.util.function.BiFunction;
import java.util.function.Function;
import lightning.render.shading.SampleMean;
import lightning.render.trace.SamplePositions;

/**
 * Samples of some pixels of a tile.
 *
 * @param pixels indices of the pixels in the tile, ascending
 * @param blocks samples, in blocks of as many whole pixels as fit into 1024 rows
 */
public record FineSamples(short[] pixels, CachedTile[] blocks) {
    // Arrays in a record: written once by their creator.

    /** Averages the samples of each pixel into the film; {@code colors} returns the colors of a block. */
    void write(Function<CachedTile, float[][]> colors, int perPixel, float[][] film) {
        int blockPixels = SampleMean.pixelsPerBatch(perPixel);
        for (int b = 0; b < blocks.length; b++) {
            int to = Math.min(pixels.length, (b + 1) * blockPixels);
            SampleMean.write(pixels, b * blockPixels, to, perPixel, colors.apply(blocks[b]), film);
        }
    }

    /**
     * Returns the same samples with other blocks, each computed from its sample positions and its old block; {@code centers}
     * are the positions of the tile.
     */
    FineSamples map(SamplePositions centers, int grid, BiFunction<SamplePositions, CachedTile, CachedTile> change) {
        int blockPixels = SampleMean.pixelsPerBatch(grid * grid);
        CachedTile[] changed = new CachedTile[blocks.length];
        for (int b = 0; b < blocks.length; b++) {
            int to = Math.min(pixels.length, (b + 1) * blockPixels);
            changed[b] = change.apply(new SamplePositions(centers.x0(), centers.y0(), pixels, b * blockPixels, to, grid), blocks[b]);
        }
        return new FineSamples(pixels, changed);
    }

    /** Returns the same samples with other blocks. */
    FineSamples map(Function<CachedTile, CachedTile> change) {
        return new FineSamples(pixels, Arrays.stream(blocks).map(change).toArray(CachedTile[]::new));
    }
}
