package lightning.editor.window.traced;

import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.function.Consumer;
import java.util.function.Function;
import lightning.base.work.OwnThread;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.editor.window.model.TracedRaster;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;

/** Traces a part of the picture alone, beside all other work; a newer region replaces an older one. */
final class RegionTracer implements AutoCloseable {
    private final ExecutorService thread = OwnThread.inTurn("lightning-region");
    private volatile Object newest;

    /**
     * @param geometry finds what the rays of a scene can meet
     * @param heard    hears of the film on the tracing thread; only the tiles that the region meets are in it
     */
    void trace(Scene scene, Function<Scene, Geometry> geometry, TracedRaster.Dirty region, Consumer<Film> heard,
            Consumer<Throwable> failed) {
        Object own = new Object();
        newest = own;
        thread.execute(() -> {
            try (var workers = new Workers(Workers.available())) {
                var tracer = new TraditionalTracer(scene, geometry.apply(scene));
                heard.accept(tracer.trace(workers, tiles(scene, region), Progress.until(() -> newest != own)).film());
            } catch (CancellationException e) {
                // A newer region is being traced.
            } catch (RuntimeException | OutOfMemoryError e) {
                failed.accept(e);
            }
        });
    }

    void cancel() {
        newest = null;
    }

    /** The numbers of the tiles that a region meets. */
    static int[] tiles(Scene scene, TracedRaster.Dirty region) {
        int across = Film.tilesAlong(scene.picture().width());
        int left = region.left() / Film.TILE;
        int top = region.top() / Film.TILE;
        int columns = (region.right() - 1) / Film.TILE - left + 1;
        int rows = (region.bottom() - 1) / Film.TILE - top + 1;
        int[] tiles = new int[columns * rows];
        for (int i = 0; i < tiles.length; i++) {
            tiles[i] = (top + i / columns) * across + left + i % columns;
        }
        return tiles;
    }

    @Override
    public void close() {
        cancel();
        thread.shutdown();
    }
}
