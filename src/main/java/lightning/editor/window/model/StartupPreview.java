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

/** Coarse pictures of a scene, traced while the window is being created. */
public final class StartupPreview {
    private final TracedRaster raster = new TracedRaster();
    private final Future<Optional<CoarsePicture>> coarse;

    private StartupPreview(ViewTransform view, Function<TracedRaster, Future<Optional<CoarsePicture>>> startTrace) {
        raster.setView(view);
        coarse = startTrace.apply(raster);
    }

    /**
     * Starts tracing coarse pictures on a dedicated thread.
     *
     * @param view  conversion from linear light to display pixels
     */
    public static StartupPreview start(Scene scene, ViewTransform view) {
        return new StartupPreview(view, raster -> {
            var trace = new FutureTask<>(
                    () -> CoarsePicture.first(scene, RenderOptions.DEFAULT, film -> raster.coarseRendered(film, scene)));
            DedicatedThread.create("lightning-startup-preview", trace).start();
            return trace;
        });
    }

    /** Returns an empty preview, which leaves all rendering to the editor. */
    public static StartupPreview none(ViewTransform view) {
        return new StartupPreview(view, _ -> CompletableFuture.completedFuture(Optional.empty()));
    }

    /** Returns the raster that receives the coarse picture and then the editor's renders. */
    public TracedRaster raster() {
        return raster;
    }

    /** Returns the last coarse picture; empty if a full picture is as fast, or if the picture is too large. */
    Future<Optional<CoarsePicture>> coarse() {
        return coarse;
    }

    /** Waits for the coarse picture with a timeout, milliseconds. */
    public void await(long milliseconds) throws InterruptedException {
        try {
            coarse.get(milliseconds, TimeUnit.MILLISECONDS);
        } catch (ExecutionException | TimeoutException e) {
            // The editor's own render follows or reports the failure.
        }
    }
}
