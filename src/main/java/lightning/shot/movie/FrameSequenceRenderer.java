package lightning.shot.movie;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.IntFunction;
import lightning.base.work.Progress;
import lightning.render.image.Film;
import lightning.render.relight.PictureTooLargeException;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.tile.RenderOptions;
import lightning.render.warmup.DelayedWarmUp;
import lightning.scene.Scene;

/** Renders frames one after the other with one running renderer: each is relit from the one before as far as that is possible. */
public final class FrameSequenceRenderer {
    private FrameSequenceRenderer() {}

    /** Hears of each frame that is there, before the next is begun. */
    public interface Listener {
        /** @param film written over afterwards */
        void frameRendered(int frame, Film film, UpdateResult update) throws IOException;
    }

    /**
     * Renders; waits until all frames are there.
     *
     * @param frames   at least one
     * @param scene    of a frame
     * @param progress hears of the tiles of each frame, and stops the work
     * @throws IOException           if the listener does
     * @throws PictureTooLargeException       if a frame does not fit into memory even where nothing of the one before is kept
     * @throws CancellationException if the progress asked for it
     */
    public static void render(List<Integer> frames, IntFunction<Scene> scene, RenderOptions options, Progress progress, Listener listener)
            throws IOException {
        try (var _ = new DelayedWarmUp(scene.apply(frames.getFirst())); var renderer = new Renderer(options)) {
            for (int frame : frames) {
                UpdateResult update = renderer.renderOrClear(scene.apply(frame), progress);
                if (progress.isCanceled()) {
                    throw new CancellationException();
                }
                listener.frameRendered(frame, renderer.film(), update);
            }
        }
    }
}
