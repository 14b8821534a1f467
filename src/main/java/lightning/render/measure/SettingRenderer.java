package lightning.render.measure;

import static java.util.Objects.requireNonNull;

import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.trace.Geometry;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Renderer of an accuracy setting that repeats an edit from the same start. */
final class SettingRenderer implements AutoCloseable {
    private final AccuracySetting setting;
    private final Renderer renderer;
    private final WorkerPool workers;
    private @Nullable PixelCache startCache;
    private @Nullable UpdateResult update;
    private @Nullable Film film;

    SettingRenderer(AccuracySetting setting, WorkerPool workers) {
        this.setting = setting;
        this.workers = workers;
        renderer = new Renderer(setting.options().withThreads(workers.count()));
    }

    AccuracySetting setting() {
        return setting;
    }

    /**
     * Traces the scene before the edit; returns its cache.
     *
     * @param memory memory limit in bytes
     * @throws lightning.render.relight.PictureTooLargeException if the limit is exceeded
     */
    PixelCache renderStart(Scene before, long memory, Progress progress) {
        startCache = null;
        renderer.clear();
        renderer.setOptions(renderer.options().withMemory(memory));
        renderer.render(setting.sceneFor(before), progress);
        return startFrom(renderer.cache());
    }

    /** Sets the cache of a renderer with the same accuracy and view as the start of edits. */
    PixelCache startFrom(PixelCache cache) {
        startCache = cache;
        return cache;
    }

    /** Renders the edit; returns milliseconds. */
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
            ms += InterleavedTimer.timeMs(() -> film = FilmUpscaler.upscale(film(), full.width(), full.height(), workers, progress));
        }
        return ms;
    }

    /** Combines two successive updates: the plan of the second, the work of both. */
    private static UpdateResult combined(UpdateResult first, UpdateResult second) {
        return new UpdateResult(second.plan(), first.rowsTouched() + second.rowsTouched(), first.rowsComposed() + second.rowsComposed(),
                first.bytesMoved() + second.bytesMoved(), first.rays().plus(second.rays()), first.nanoseconds() + second.nanoseconds(),
                second.errorBound(),
                first.wasRefreshed() || second.wasRefreshed());
    }

    /**
     * Verifies the last image.
     *
     * @throws GuaranteeViolation if the setting's guarantee is violated
     */
    void verify(Progress progress) {
        GuaranteeViolation.require(AccuracyGuarantee.of(renderer, update()).verify(renderer.film(), workers, progress), setting);
    }

    /** Returns the image after the last edit, at full size. */
    Film film() {
        return requireNonNull(film);
    }

    Geometry geometry() {
        return renderer.cache().geometry();
    }

    /**
     * Returns the last update. For {@link AccuracySetting#EXACT_UPDATED}, it has the plan of the reflections' update and the work of both.
     */
    UpdateResult update() {
        return requireNonNull(update);
    }

    @Override
    public void close() {
        renderer.close();
    }
}
