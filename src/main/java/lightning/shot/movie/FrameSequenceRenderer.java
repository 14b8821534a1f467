package lightning.shot.movie;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.IntFunction;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.relight.PictureTooLargeException;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.warmup.DelayedLanes;
import lightning.scene.Scene;

/** Sequential renderer of frames: relights each frame from the one before as far as possible. */
public final class FrameSequenceRenderer {
    private FrameSequenceRenderer() {}

    /** Listener that receives each finished frame before the next starts. */
    public interface Listener {
        /** @param cache cache of the frame, whose colors are those of its film */
        void frameRendered(int frame, PixelCache cache, UpdateResult update) throws IOException;
    }

    /**
     * Renders all frames and waits for them.
     *
     * @param frames   at least one
     * @param scene    scene of a frame
     * @param progress receives the tiles of each frame, and can cancel
     * @throws IOException           if the listener throws it
     * @throws PictureTooLargeException       if a frame does not fit into memory even without the cache of the one before
     * @throws CancellationException if the progress canceled
     */
    public static void render(List<Integer> frames, IntFunction<Scene> scene, RenderOptions options, Progress progress, Listener listener)
            throws IOException {
        try (var _ = new DelayedLanes(); var renderer = new Renderer(options)) {
            for (int frame : frames) {
                UpdateResult update = renderer.renderOrClear(scene.apply(frame), progress);
                progress.checkCanceled("canceled while a frame was rendered");
                listener.frameRendered(frame, renderer.cache(), update);
            }
        }
    }
}
