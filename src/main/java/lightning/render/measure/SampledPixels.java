package lightning.render.measure;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.cache.PixelCache;
import lightning.render.cache.TileLevel;
import lightning.render.image.Film;
import lightning.render.trace.HitRows;
import lightning.scene.PictureSettings;

/** Random pixels of a picture, which are numbered line by line from the top. */
final class SampledPixels {
    private static final int CHUNK = 32;

    private SampledPixels() {}

    /** Computation for one pixel. */
    interface Reference<T> {
        /** @return empty if the pixel does not count */
        Optional<T> of(int worker, int pixel);
    }

    /**
     * Computes a reference at random pixels, always in the same order, until either limit is reached.
     *
     * @param maxPixels maximum number of pixels that are tried
     * @param maxMs     time after which no further pixels are computed, milliseconds
     * @throws java.util.concurrent.CancellationException if {@code progress} requests a stop
     */
    static <T> List<T> compute(PictureSettings picture, long seed, WorkerPool workers, int maxPixels, double maxMs, Progress progress,
            Reference<T> reference) {
        SplittableRandom random = new SplittableRandom(seed);
        List<T> found = new ArrayList<>();
        long start = System.nanoTime();
        for (int done = 0; done < maxPixels && (done == 0 || (System.nanoTime() - start) / 1e6 < maxMs); done += CHUNK) {
            int[] chunk = random.ints(Math.min(CHUNK, maxPixels - done), 0, picture.width() * picture.height()).toArray();
            List<Optional<T>> results = new ArrayList<>(Collections.nCopies(chunk.length, Optional.empty()));
            workers.run(chunk.length, (worker, i) -> results.set(i, reference.of(worker, chunk[i])), progress.cancellationOnly());
            results.stream().flatMap(Optional::stream).forEach(found::add);
            progress.report(done, maxPixels);
        }
        return found;
    }

    /** Returns the surfaces seen directly in the tile of a pixel. */
    static TileLevel level(PixelCache cache, int pixel) {
        int width = cache.scene().picture().width();
        return cache.tile(pixel / width / Film.TILE_SIZE * Film.tilesAlong(width) + pixel % width / Film.TILE_SIZE).levels()[0];
    }

    /** Returns the row of a pixel among those of its tile; −1 if it has none. */
    static int row(PixelCache cache, HitRows rows, int pixel) {
        int width = cache.scene().picture().width();
        int parent = pixel / width % Film.TILE_SIZE * Film.TILE_SIZE + pixel % width % Film.TILE_SIZE;
        for (int row = 0; row < rows.count; row++) {
            if (rows.parent[row] == parent) {
                return row;
            }
        }
        return -1;
    }
}
