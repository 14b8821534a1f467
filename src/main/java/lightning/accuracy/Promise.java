package lightning.accuracy;

import lightning.image.Difference;
import lightning.image.Film;
import lightning.relight.Accuracy;
import lightning.relight.Renderer;
import lightning.relight.Update;
import lightning.scene.Scene;
import lightning.shading.Progress;
import lightning.shading.TraditionalTracer;
import lightning.effects.ViewEffects;
import lightning.shading.Workers;

/**
 * What a renderer's picture must be.
 *
 * @param oracle a trace from nothing of what the renderer claims to show
 * @param bound  how far a value may be off, linear; 0 where every bit must agree
 */
record Promise(Film oracle, double bound) {

    /**
     * The promise for a renderer's last update. Where all effects are shown, the oracle is a full trace that keeps nothing, its
     * mirrors and samples those of the picture; else a first pass with the same effects.
     */
    static Promise of(Renderer renderer, Update update, Workers workers, Progress progress) {
        double bound = renderer.options().accuracy() == Accuracy.EXACT ? 0 : update.errorBound();
        if (renderer.options().view().equals(ViewEffects.ALL)) {
            var tracer = new TraditionalTracer(renderer.scene(), renderer.cache().mirroredScene(), renderer.cache().geometry());
            return new Promise(tracer.trace(workers, progress).film(), bound);
        }
        try (Renderer fresh = new Renderer(renderer.options())) {
            Scene shown = renderer.scene();
            fresh.render(shown, progress);
            return new Promise(fresh.film(), bound);
        }
    }

    boolean isKeptBy(Film film) {
        return bound == 0 ? film.sameBits(oracle) : Difference.of(film, oracle).maxAbsolute() <= bound;
    }

    /**
     * Requires that a picture keeps it.
     *
     * @throws BrokenPromise if it does not; the message says how far it is off
     */
    void require(Film film, Level level) {
        if (!isKeptBy(film)) {
            Difference d = Difference.of(film, oracle);
            throw new BrokenPromise("level " + level.label() + ": " + d.values() + " values differ from the oracle, by up to "
                    + d.maxAbsolute() + " where " + bound + " is promised, first at pixel " + d.x() + "," + d.y() + "; not measured");
        }
    }
}
