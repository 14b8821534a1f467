package lightning.layer;

import java.util.Arrays;
import lightning.render.cache.FineSamples;
import lightning.render.cache.FineTile;
import lightning.render.cache.PixelCache;
import lightning.render.engine.Engine;
import lightning.render.image.Film;
import lightning.render.shading.SampleMean;
import lightning.render.trace.SamplePositions;
import lightning.render.trace.TileVisibility;
import org.jspecify.annotations.Nullable;

/**
 * Primitives that the camera rays of a tile hit first: for each pixel those of the samples of which its color is the mean. Traces
 * these rays again. Holds scratch memory: use one per thread.
 */
final class PixelHits {
    private final PixelCache cache;
    private final TileVisibility visibility;
    /** Index of each pixel's first hit; the next pixel's is the end. */
    private final int[] start = new int[Film.TILE_PIXELS + 1];
    /** Index of each pixel's next hit to write. */
    private final int[] next = new int[Film.TILE_PIXELS];
    private int[] hits = {};

    PixelHits(PixelCache cache, Engine engine) {
        this.cache = cache;
        visibility = new TileVisibility(cache.geometry(), cache.scene(), engine.tracer(cache.geometry()));
    }

    /** Traces the rays of a tile. */
    void trace(int tile, SamplePositions centers) {
        FineTile fine = cache.fineCount() == 0 ? null : cache.fineTile(tile);
        int[] counts = new int[Film.TILE_PIXELS];
        boolean needsCenters = countSamples(fine, counts);
        for (int pixel = 0; pixel < counts.length; pixel++) {
            start[pixel + 1] = start[pixel] + counts[pixel];
        }
        System.arraycopy(start, 0, next, 0, next.length);
        if (hits.length < start[Film.TILE_PIXELS]) {
            hits = new int[start[Film.TILE_PIXELS]];
        }
        if (needsCenters) {
            traceCenters(centers, fine);
        }
        if (fine != null) {
            fine.stages().forEach(samples -> traceSamples(samples, centers));
        }
    }

    /** Counts the samples of each pixel, and returns whether any pixel shows its center. */
    private boolean countSamples(@Nullable FineTile fine, int[] counts) {
        Arrays.fill(counts, 1);
        if (fine == null) {
            return true;
        }
        for (short pixel : fine.first().pixels()) {
            counts[pixel] = 0;
        }
        boolean needsCenters = cache.tileCount() > 0 && fine.first().pixels().length < Film.TILE_PIXELS;
        for (FineSamples samples : fine.stages()) {
            for (short pixel : samples.pixels()) {
                counts[pixel] += samples.cells().count();
            }
        }
        return needsCenters;
    }

    private void traceCenters(SamplePositions centers, @Nullable FineTile fine) {
        int columns = Math.min(Film.TILE_SIZE, cache.scene().picture().width() - centers.x0());
        int[] primitives = visibility.primitives(centers);
        boolean[] isFine = new boolean[Film.TILE_PIXELS];
        if (fine != null) {
            for (short pixel : fine.first().pixels()) {
                isFine[pixel] = true;
            }
        }
        for (int i = 0; i < primitives.length; i++) {
            int pixel = i / columns * Film.TILE_SIZE + i % columns;
            if (!isFine[pixel]) {
                hits[next[pixel]++] = primitives[i];
            }
        }
    }

    private void traceSamples(FineSamples samples, SamplePositions centers) {
        short[] pixels = samples.pixels();
        int perPixel = samples.cells().count();
        int batch = pixels.length == 0 ? 1 : SampleMean.pixelsPerBatch(perPixel);
        for (int from = 0; from < pixels.length; from += batch) {
            short[] some = Arrays.copyOfRange(pixels, from, Math.min(from + batch, pixels.length));
            int[] primitives = visibility.primitives(new SamplePositions(centers.x0(), centers.y0(), some, samples.cells()));
            for (int i = 0; i < primitives.length; i++) {
                hits[next[some[i / perPixel]]++] = primitives[i];
            }
        }
    }

    /** Returns the number of samples of a pixel inside the image. */
    int count(int pixel) {
        return start[pixel + 1] - start[pixel];
    }

    /** Returns the primitive that a sample of a pixel hits, −1 for none. */
    int primitive(int pixel, int sample) {
        return hits[start[pixel] + sample];
    }
}
