package lightning.editor.window.model;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Function;
import lightning.base.work.DedicatedThread;
import lightning.editor.loop.CoarsePicture;
import lightning.render.image.ViewTransform;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.Scene;

/** What a window shows of a scene before there is an editor of it: a coarse picture, traced while the window is made. */
public final class StartupPreview {
    private final TracedRaster raster = new TracedRaster();
    private final Future<Optional<CoarsePicture>> coarse;

    private StartupPreview(ViewTransform view, Function<TracedRaster, Future<Optional<CoarsePicture>>> startTrace) {
        raster.setView(view);
        coarse = startTrace.apply(raster);
    }

    /**
     * Begins to trace it, on a thread of its own.
     *
     * @param view how linear light becomes display pixels
     */
    public static StartupPreview start(Scene scene, ViewTransform view) {
        return new StartupPreview(view, raster -> {
            var trace = new FutureTask<>(() -> {
                Optional<CoarsePicture> first = CoarsePicture.first(scene, RenderOptions.DEFAULT);
                first.ifPresent(picture -> raster.coarseRendered(picture.film(), scene));
                return first;
            });
            DedicatedThread.create("lightning-glimpse", trace).start();
            return trace;
        });
    }

    /** Leaves all to the editor. */
    public static StartupPreview none(ViewTransform view) {
        return new StartupPreview(view, _ -> CompletableFuture.completedFuture(Optional.empty()));
    }

    /** Shows it when it is there, and what the editor traces after that. */
    public TracedRaster raster() {
        return raster;
    }

    /** What is traced: empty where the picture itself is there as soon, or too large to be made. */
    Future<Optional<CoarsePicture>> coarse() {
        return coarse;
    }

    /** Waits for it, but not for long. */
    public void await(long milliseconds) throws InterruptedException {
        try {
            coarse.get(milliseconds, TimeUnit.MILLISECONDS);
        } catch (ExecutionException | TimeoutException e) {
            // The editor's own picture comes, or says why it cannot.
        }
    }
}
