package lightning.layer;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrType;
import lightning.render.cache.CachedTile;
import lightning.render.cache.FineSamples;
import lightning.render.cache.PixelCache;
import lightning.render.engine.Engine;
import lightning.render.image.Film;

/**
 * Alpha, and surface data averaged over the samples that a pixel's color is the mean of. Alpha is the share of samples whose ray hits a
 * surface, faces of lights included. Normals and colors are means over all samples, with 0 for the background, as denoisers expect.
 * Positions and depths are means over the samples that hit a surface, because the background has none. All come from stored rows; no ray is
 * cast.
 *
 * @param colorType type of alpha, normals and colors; all other channels are FLOAT
 */
record FilteredChannels(PixelCache cache, ExrType colorType) implements ChannelSource {
    private static final String SUFFIX = "_filtered";
    /** Channels of normals, positions and the others; alpha comes first. */
    private static final int NORMAL = 1;
    private static final int POSITION = NORMAL + SurfaceValues.POSITION;
    private static final int DEPTH = NORMAL + SurfaceValues.DEPTH;
    private static final int COLOR = NORMAL + SurfaceValues.COLOR;

    /** Returns whether any pixel has several samples: else averages equal the surface data of its center. */
    private boolean hasAverages() {
        return cache.scene().picture().sampling().isSupersampled();
    }

    @Override
    public List<ExrChannel> channels() {
        List<ExrChannel> channels = new ArrayList<>(List.of(new ExrChannel("A", colorType)));
        if (hasAverages()) {
            channels.addAll(SurfaceValues.channels(SUFFIX, "Z" + SUFFIX + ".Z", colorType));
        }
        return channels;
    }

    @Override
    public TileWriter writer(Engine engine) {
        RowValues values = new RowValues(cache);
        return (tile, _, sink) -> {
            int[] counts = sampleCounts(tile);
            float[][] hitsAndDepths = means(tile, values::hitsAndDepths);
            // The mean of zeros and ones is rounded: their number is exact.
            int[] hits = new int[Film.TILE_PIXELS];
            Arrays.setAll(hits, pixel -> Math.round(hitsAndDepths[0][pixel] * counts[pixel]));
            sink.forEachPixel((x, y, pixel) -> sink.put(0, x, y, (float) hits[pixel] / counts[pixel]));
            if (hasAverages()) {
                sink.putColors(NORMAL, means(tile, values::normals));
                sink.putColors(COLOR, means(tile, values::colors));
                float[][] positions = means(tile, values::positions);
                sink.forEachPixel((x, y, pixel) -> {
                    double factor = hits[pixel] == 0 ? 0 : (double) counts[pixel] / hits[pixel];
                    for (int axis = 0; axis < 3; axis++) {
                        sink.put(POSITION + axis, x, y, (float) (positions[axis][pixel] * factor));
                    }
                    sink.put(DEPTH, x, y,
                            hits[pixel] == 0 ? SurfaceValues.BACKGROUND_DEPTH : (float) (hitsAndDepths[1][pixel] * factor));
                });
            }
        };
    }

    /** Returns the means of values over the samples of each pixel. */
    private float[][] means(int tile, Function<CachedTile, float[][]> values) {
        CachedTile center = cache.tileCount() == 0 ? null : cache.tile(tile);
        return cache.fineCount() == 0 ? values.apply(requireNonNull(center)) : cache.fineTile(tile).film(center, values);
    }

    /** Returns the samples of each pixel. */
    private int[] sampleCounts(int tile) {
        int[] counts = new int[Film.TILE_PIXELS];
        Arrays.fill(counts, 1);
        if (cache.fineCount() > 0) {
            for (short pixel : cache.fineTile(tile).first().pixels()) {
                counts[pixel] = 0;
            }
            for (FineSamples samples : cache.fineTile(tile).stages()) {
                for (short pixel : samples.pixels()) {
                    counts[pixel] += samples.cells().count();
                }
            }
        }
        return counts;
    }
}
