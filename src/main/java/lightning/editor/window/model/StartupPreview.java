package lightning.editor.window.model;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Function;
import lightning.base.work.DedicatedThread;
import lightning.document.loop.CoarsePicture;
import lightning.render.RenderOptions;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;

/** Coarse pictures of a scene, traced while the window is being created. */
public final class StartupPreview {
    /** Maximum wait of the editor's render for the menus. */
    private static final long MAX_WAIT_SECONDS = 10;

    private final TracedRaster raster = new TracedRaster();
    private final CompletableFuture<Optional<CoarsePicture>> coarse;
    private final CompletableFuture<Void> menusShown = new CompletableFuture<>();

    private StartupPreview(ViewTransform view, Function<TracedRaster, CompletableFuture<Optional<CoarsePicture>>> startTrace) {
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
            var trace = new CompletableFuture<Optional<CoarsePicture>>();
            DedicatedThread.create("lightning-startup-preview", () -> {
                try {
                    trace.complete(CoarsePicture.first(scene, RenderOptions.DEFAULT, film -> raster.coarseRendered(film, scene)));
                } catch (RuntimeException | Error e) {
                    trace.completeExceptionally(e);
                }
            }).start();
            return trace;
        });
    }

    /** Returns an empty preview, which leaves all rendering to the editor. */
    public static StartupPreview none(ViewTransform view) {
        var preview = new StartupPreview(view, _ -> CompletableFuture.completedFuture(Optional.empty()));
        preview.endStartup();
        return preview;
    }

    /** Returns the raster that receives the coarse picture and then the editor's renders. */
    public TracedRaster raster() {
        return raster;
    }

    /** Returns the last coarse picture; empty if a full picture is as fast, or if the picture is too large. */
    Future<Optional<CoarsePicture>> coarse() {
        return coarse;
    }

    /** Returns when the menus are shown, from which on tracing may use all processors. */
    Future<?> menusShown() {
        return menusShown.completeOnTimeout(null, MAX_WAIT_SECONDS, TimeUnit.SECONDS);
    }

    /** Lets the editor's own render use all processors: the menus are shown, or the window is closed. */
    public void endStartup() {
        menusShown.complete(null);
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
