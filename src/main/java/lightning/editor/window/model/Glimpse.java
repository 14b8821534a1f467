package lightning.editor.window.model;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.Future;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Function;
import lightning.base.work.OwnThread;
import lightning.editor.loop.CoarsePicture;
import lightning.render.image.ViewTransform;
import lightning.render.relight.tile.Options;
import lightning.scene.Scene;

/** What a window shows of a scene before there is an editor of it: a coarse picture, traced while the window is made. */
public final class Glimpse {
    private final TracedRaster raster = new TracedRaster();
    private final Future<Optional<CoarsePicture>> coarse;

    private Glimpse(ViewTransform view, Function<TracedRaster, Future<Optional<CoarsePicture>>> begun) {
        raster.setView(view);
        coarse = begun.apply(raster);
    }

    /**
     * Begins to trace it, on a thread of its own.
     *
     * @param view how linear light becomes display pixels
     */
    public static Glimpse begin(Scene scene, ViewTransform view) {
        return new Glimpse(view, raster -> {
            var trace = new FutureTask<>(() -> {
                Optional<CoarsePicture> first = CoarsePicture.first(scene, Options.DEFAULT);
                first.ifPresent(picture -> raster.coarse(picture.film(), scene));
                return first;
            });
            OwnThread.of("lightning-glimpse", trace).start();
            return trace;
        });
    }

    /** Leaves all to the editor. */
    public static Glimpse none(ViewTransform view) {
        return new Glimpse(view, _ -> CompletableFuture.completedFuture(Optional.empty()));
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
