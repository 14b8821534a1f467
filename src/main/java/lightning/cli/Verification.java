package lightning.cli;

import lightning.image.Difference;
import lightning.image.Film;
import lightning.relight.Accuracy;
import lightning.relight.Renderer;
import lightning.relight.Update;
import lightning.scene.Scene;
import lightning.shading.Progress;
import lightning.shading.TraditionalTracer;
import lightning.shading.Workers;

/**
 * What a re-render promised, and whether it kept it.
 *
 * @param promised the difference to the full trace that the picture must agree with: at stale reflections one whose
 *                 mirrors show the scene of their last update
 * @param current  the difference to a full trace of the edited scene, mirrors included
 * @param stale    whether the mirrors show an older scene
 * @param bound    how far a value may be off, linear; 0 where every bit must agree
 */
record Verification(Difference promised, Difference current, boolean stale, double bound) {

    /** Verifies the renderer's picture by full traces that keep nothing. */
    static Verification of(Renderer renderer, Update update, Workers workers, Progress progress) {
        Scene scene = renderer.scene();
        Scene mirrored = renderer.cache().mirroredScene();
        Film film = renderer.film();
        var geometry = renderer.cache().geometry();
        Difference current = Difference.of(film, new TraditionalTracer(scene, geometry).trace(workers, progress).film());
        boolean stale = !mirrored.equals(scene);
        Difference promised = !stale ? current : Difference.of(film,
                new TraditionalTracer(scene, mirrored, geometry).trace(workers, progress).film());
        return new Verification(promised, current, stale, renderer.options().accuracy() == Accuracy.EXACT ? 0 : update.errorBound());
    }

    boolean kept() {
        return bound == 0 ? promised.isNone() : promised.maxAbsolute() <= bound;
    }

    String text() {
        String text = (kept() ? "verified: " : "NOT KEPT: ") + difference(promised);
        if (bound > 0) {
            text += Console.text(", by at most %.3g of %.3g allowed", promised.maxAbsolute(), bound);
        }
        if (stale) {
            text += Console.text("; mirrors show the scene of their last update, %d pixels differ from updated ones", current.pixels());
        }
        return text;
    }

    private static String difference(Difference d) {
        return Console.text("%d pixels, %d values differ from a full trace", d.pixels(), d.values());
    }
}
