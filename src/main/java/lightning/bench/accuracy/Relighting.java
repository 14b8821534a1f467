package lightning.bench.accuracy;

import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.relight.Update;
import lightning.render.trace.Geometry;
import lightning.scene.Picture;
import lightning.scene.Scene;

/** A grade's renderer: makes an edit again and again from the same start. */
final class Relighting implements AutoCloseable {
    private final Grade grade;
    private final Renderer renderer;
    private final Workers workers;
    private PixelCache start;
    private Update update;
    private Film film;

    Relighting(Grade grade, Workers workers) {
        this.grade = grade;
        this.workers = workers;
        renderer = new Renderer(grade.options().withThreads(workers.count()));
    }

    Grade grade() {
        return grade;
    }

    /**
     * Traces the scene that edits start from; returns what is kept of it.
     *
     * @param memory bytes that it may take
     * @throws lightning.render.relight.PictureTooLarge if it takes more
     */
    PixelCache begin(Scene before, long memory, Progress progress) {
        start = null;
        renderer.forget();
        renderer.change(renderer.options().withMemory(memory));
        renderer.render(grade.of(before), progress);
        return begin(renderer.cache());
    }

    /** Lets edits start from what a renderer of the same accuracy and view keeps. */
    PixelCache begin(PixelCache kept) {
        start = kept;
        return kept;
    }

    /** Makes the edit; returns milliseconds. */
    double edit(Scene after, Progress progress) {
        renderer.restore(start);
        update = renderer.render(grade.of(after), progress);
        double ms = update.milliseconds();
        film = renderer.film();
        if (grade == Grade.EXACT_UPDATED) {
            update = both(update, renderer.updateReflections(progress));
            ms = update.milliseconds();
            film = renderer.film();
        } else if (grade == Grade.HALF_RESOLUTION) {
            Picture full = after.picture();
            ms += Turns.time(() -> film = Enlarger.enlarge(film, full.width(), full.height(), workers, progress));
        }
        return ms;
    }

    /** One update after another: the second's plan, the work of both. */
    private static Update both(Update a, Update b) {
        return new Update(b.plan(), a.rowsTouched() + b.rowsTouched(), a.rowsComposed() + b.rowsComposed(),
                a.bytesMoved() + b.bytesMoved(), a.rays().plus(b.rays()), a.nanoseconds() + b.nanoseconds(), b.errorBound(),
                a.refreshed() || b.refreshed());
    }

    /**
     * Compares the last picture with its oracle.
     *
     * @throws BrokenPromise if the grade's promise is not kept
     */
    void verify(Progress progress) {
        BrokenPromise.require(Promise.of(renderer, update).verify(renderer.film(), workers, progress), grade);
    }

    /** The picture after the last edit, at full size. */
    Film film() {
        return film;
    }

    Geometry geometry() {
        return renderer.cache().geometry();
    }

    /** What the last edit did; of {@link Grade#EXACT_UPDATED} the plan of the mirrors and the work of both. */
    Update update() {
        return update;
    }

    @Override
    public void close() {
        renderer.close();
    }
}
