package lightning.editor.window.timeline;

import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicBoolean;
import lightning.base.work.HeapBudget;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.relight.MemoryEstimate;
import lightning.render.relight.Renderer;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;
import lightning.shot.LocalFrameHost;
import lightning.shot.ShotListener;
import lightning.shot.ShotRelighter;

/**
 * Thumbnail-size frames rendered in this process. Rendering of the main picture has priority.
 *
 * @param pictureBusy true while the main picture is being rendered
 */
record LocalFrames(ShotRelighter shot, AtomicBoolean pictureBusy) implements FilmStripFrames {
    static LocalFrames of(Shot shot, Scene scene, ShotListener listener) {
        int threads = Math.max(1, WorkerPool.processorCount() - 1);
        var host = new LocalFrameHost(options().withThreads(threads), budget());
        var pictureBusy = new AtomicBoolean();
        return new LocalFrames(ShotRelighter.of(shot.first(), shot.last(), new PausingFrameHost(host, pictureBusy::get), listener),
                pictureBusy);
    }

    private static RenderOptions options() {
        return RenderOptions.DEFAULT;
    }

    /** Returns the memory that a shot's thumbnails may take, bytes. */
    static long budget() {
        return HeapBudget.availableBytes() / 2;
    }

    /**
     * Measures the memory of a thumbnail and its relighting cache, bytes. Renders the thumbnail; do not call this on a window's thread. The
     * upper bound of the estimate is several times as much, because few pixels have all samples.
     */
    static long measureBytes(Scene scene) {
        Scene small = FilmStrip.thumbnailScene(scene);
        PictureSettings picture = small.picture();
        try (Renderer renderer = new Renderer(options().withThreads(1))) {
            renderer.render(small, Progress.NONE);
            return MemoryEstimate.usedBytes(renderer.cache()) + 4L * picture.width() * picture.height();
        }
    }

    @Override
    public Scene frameScene(Scene scene) {
        return FilmStrip.thumbnailScene(scene);
    }

    @Override
    public OptionalInt machineCount() {
        return OptionalInt.empty();
    }

    @Override
    public void setPictureBusy(boolean v) {
        pictureBusy.set(v);
    }

    @Override
    public void close() {
        pictureBusy.set(false);
        shot.close();
    }
}
