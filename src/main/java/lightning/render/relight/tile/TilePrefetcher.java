package lightning.render.relight.tile;

import lightning.render.cache.CachedTile;
import lightning.render.cache.TileLevel;
import lightning.render.shading.layer.LightLayer;
import lightning.render.shading.layer.LightRows;
import org.jspecify.annotations.Nullable;

/**
 * Prefetches the small objects between tiles and their columns into the processor's cache. A tile has about ten of them in a chain,
 * and each access waits for the previous one. Prefetching several tiles overlaps these waits. It changes only the time (figures:
 * docs/performance.md). Use one instance per thread.
 */
final class TilePrefetcher {
    /** Maximum number of tiles per call: enough to overlap the waits, few enough to stay in the cache. */
    static final int MAX_TILES = 8;

    private final TileLevel[][] levels = new TileLevel[MAX_TILES][];
    private final TileLevel[] topLevels = new TileLevel[MAX_TILES];
    private final LightLayer[][] layers = new LightLayer[MAX_TILES][];

    /** Accumulates the data read, so that the JIT cannot remove the reads. */
    long checksum;

    /** Prefetches tiles {@code from … to − 1}, one to {@link #MAX_TILES} of one picture. */
    void prefetch(CachedTile[] tiles, int from, int to) {
        int count = to - from;
        long sum = 0;
        for (int t = 0; t < count; t++) {
            levels[t] = tiles[from + t].levels;
        }
        for (int t = 0; t < count; t++) {
            topLevels[t] = levels[t][0];
        }
        for (int t = 0; t < count; t++) {
            layers[t] = topLevels[t].layers();
            sum += topLevels[t].rows().count;
        }
        for (int t = 0; t < count; t++) {
            sum += layers[t].length + topLevels[t].rows().runEnd[0] + topLevels[t].rows().runMaterial[0]
                    + topLevels[t].rows().parent.length;
        }
        for (int l = 0; l < layers[0].length; l++) {
            for (int t = 0; t < count; t++) {
                sum += layers[t][l] == null ? 0 : layers[t][l].litCount();
            }
        }
        for (int l = 0; l < layers[0].length; l++) {
            for (int t = 0; t < count; t++) {
                sum += layers[t][l] instanceof LightRows layer ? lengths(layer) : 0;
            }
        }
        checksum = sum;
    }

    /** Reads the array lengths, which precede the values in memory. */
    private static int lengths(LightRows layer) {
        return layer.litCount == 0 ? 0 : length(layer.cosine) + length(layer.specular) + length(layer.falloff);
    }

    private static int length(float @Nullable [] column) {
        return column == null ? 0 : column.length;
    }
}
