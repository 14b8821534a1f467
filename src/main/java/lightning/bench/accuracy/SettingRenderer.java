package lightning.bench.accuracy;

import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.trace.Geometry;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;

/** A grade's renderer: makes an edit again and again from the same start. */
final class SettingRenderer implements AutoCloseable {
    private final AccuracySetting setting;
    private final Renderer renderer;
    private final WorkerPool workers;
    private PixelCache startCache;
    private UpdateResult update;
    private Film film;

    SettingRenderer(AccuracySetting setting, WorkerPool workers) {
        this.setting = setting;
        this.workers = workers;
        renderer = new Renderer(setting.options().withThreads(workers.count()));
    }

    AccuracySetting setting() {
        return setting;
    }

    /**
     * Traces the scene that edits start from; returns what is kept of it.
     *
     * @param memory bytes that it may take
     * @throws lightning.render.relight.PictureTooLargeException if it takes more
     */
    PixelCache renderStart(Scene before, long memory, Progress progress) {
        startCache = null;
        renderer.clear();
        renderer.setOptions(renderer.options().withMemory(memory));
        renderer.render(setting.sceneFor(before), progress);
        return startFrom(renderer.cache());
    }

    /** Lets edits start from what a renderer of the same accuracy and view keeps. */
    PixelCache startFrom(PixelCache cache) {
        startCache = cache;
        return cache;
    }

    /** Makes the edit; returns milliseconds. */
    double applyEdit(Scene after, Progress progress) {
        renderer.restore(startCache);
        update = renderer.render(setting.sceneFor(after), progress);
        double ms = update.milliseconds();
        film = renderer.film();
        if (setting == AccuracySetting.EXACT_UPDATED) {
            update = combined(update, renderer.updateReflections(progress));
            ms = update.milliseconds();
            film = renderer.film();
        } else if (setting == AccuracySetting.HALF_RESOLUTION) {
            PictureSettings full = after.picture();
            ms += InterleavedTimer.timeMs(() -> film = FilmUpscaler.upscale(film, full.width(), full.height(), workers, progress));
        }
        return ms;
    }

    /** One update after another: the second's plan, the work of both. */
    private static UpdateResult combined(UpdateResult first, UpdateResult second) {
        return new UpdateResult(second.plan(), first.rowsTouched() + second.rowsTouched(), first.rowsComposed() + second.rowsComposed(),
                first.bytesMoved() + second.bytesMoved(), first.rays().plus(second.rays()), first.nanoseconds() + second.nanoseconds(),
                second.errorBound(),
                first.wasRefreshed() || second.wasRefreshed());
    }

    /**
     * Compares the last picture with its oracle.
     *
     * @throws GuaranteeViolation if the grade's promise is not kept
     */
    void verify(Progress progress) {
        GuaranteeViolation.require(AccuracyGuarantee.of(renderer, update).verify(renderer.film(), workers, progress), setting);
    }

    /** The picture after the last edit, at full size. */
    Film film() {
        return film;
    }

    Geometry geometry() {
        return renderer.cache().geometry();
    }

    /** What the last edit did; of {@link AccuracySetting#EXACT_UPDATED} the plan of the mirrors and the work of both. */
    UpdateResult update() {
        return update;
    }

    @Override
    public void close() {
        renderer.close();
    }
}
