package lightning.editor.window.timeline;

import java.util.OptionalInt;
import java.util.concurrent.atomic.AtomicBoolean;
import lightning.base.work.HeapBudget;
import lightning.base.work.WorkerPool;
import lightning.render.relight.MemoryEstimate;
import lightning.render.relight.plan.ReflectionMode;
import lightning.render.relight.tile.RenderOptions;
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
        var host = new LocalFrameHost(options().withThreads(threads), maxBytes(scene, shot));
        var pictureBusy = new AtomicBoolean();
        return new LocalFrames(ShotRelighter.of(shot.first(), shot.last(), new PausingFrameHost(host, pictureBusy::get), listener),
                pictureBusy);
    }

    private static RenderOptions options() {
        return RenderOptions.DEFAULT.withReflections(ReflectionMode.CURRENT);
    }

    /** Returns the memory that a shot's thumbnails may take, bytes. */
    static long budget() {
        return HeapBudget.availableBytes() / 2;
    }

    /**
     * Returns the maximum memory of a shot's thumbnails and their relighting caches, bytes. With indirect light it is at most the budget:
     * the bound of its paths is hundreds of times what they take, and frames that do not fit are traced again.
     */
    static long maxBytes(Scene scene, Shot shot) {
        Scene small = FilmStrip.thumbnailScene(scene);
        PictureSettings picture = small.picture();
        long bytesPerFrame = MemoryEstimate.upperBound(small, options()) + 4L * picture.width() * picture.height();
        long bytes = bytesPerFrame * ((long) shot.last() - shot.first() + 1);
        return picture.indirect().isPresent() ? Math.min(bytes, budget()) : bytes;
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
