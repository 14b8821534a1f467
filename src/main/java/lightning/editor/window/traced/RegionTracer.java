package lightning.editor.window.traced;

import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.function.Consumer;
import java.util.function.Function;
import lightning.base.work.DedicatedThread;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.editor.window.model.TracedRaster;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Traces a region of the picture in the background. A new region replaces the previous one. */
final class RegionTracer implements AutoCloseable {
    private final ExecutorService thread = DedicatedThread.sequentialExecutor("lightning-region");
    private volatile @Nullable Object latest;

    /**
     * Starts to trace a region.
     *
     * @param geometry returns the geometry of a scene
     * @param onFilm receives the film on the tracing thread; it contains only the tiles that intersect the region
     */
    void trace(Scene scene, Function<Scene, Geometry> geometry, TracedRaster.DirtyRect region, Consumer<Film> onFilm,
            Consumer<Throwable> onFailure) {
        Object token = new Object();
        latest = token;
        thread.execute(() -> {
            try (var workers = new WorkerPool(WorkerPool.processorCount())) {
                var tracer = new TraditionalTracer(scene, geometry.apply(scene));
                onFilm.accept(tracer.trace(workers, tiles(scene, region), Progress.cancellation(() -> latest != token)).film());
            } catch (CancellationException e) {
                // A newer region is being traced.
            } catch (RuntimeException | OutOfMemoryError e) {
                onFailure.accept(e);
            }
        });
    }

    void cancel() {
        latest = null;
    }

    /** Returns the indices of the tiles that intersect a region. */
    static int[] tiles(Scene scene, TracedRaster.DirtyRect region) {
        int tilesPerRow = Film.tilesAlong(scene.picture().width());
        int left = region.left() / Film.TILE_SIZE;
        int top = region.top() / Film.TILE_SIZE;
        int columns = (region.right() - 1) / Film.TILE_SIZE - left + 1;
        int rows = (region.bottom() - 1) / Film.TILE_SIZE - top + 1;
        int[] tiles = new int[columns * rows];
        for (int i = 0; i < tiles.length; i++) {
            tiles[i] = (top + i / columns) * tilesPerRow + left + i % columns;
        }
        return tiles;
    }

    @Override
    public void close() {
        cancel();
        thread.shutdown();
    }
}
