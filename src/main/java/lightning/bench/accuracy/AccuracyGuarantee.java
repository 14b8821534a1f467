package lightning.bench.accuracy;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.concurrent.CancellationException;
import lightning.base.text.Messages;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Difference;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.ReflectionMode;
import lightning.render.relight.tile.RenderOptions;
import lightning.render.shading.RenderedScenes;
import lightning.render.trace.Geometry;
import lightning.scene.effects.ViewEffects;

/**
 * What a picture is said to be: the one promise that the status line, Verify, {@code relight --verify}, the harness and the
 * tests speak of.
 *
 * @param scenes what the picture and its mirrors show
 * @param view  which effects are shown; all of them in a picture
 * @param bound how far a value may be off, linear, finite; 0 where every bit must agree with a full trace of the scenes
 */
public record AccuracyGuarantee(RenderedScenes scenes, ViewEffects view, double bound) {

    /** The promise for a renderer's last update. */
    public static AccuracyGuarantee of(Renderer renderer, UpdateResult update) {
        return new AccuracyGuarantee(renderer.cache().scenes(), renderer.options().view(), update.errorBound());
    }

    /** Whether the mirrors show an older scene, as far as a picture can tell. */
    public boolean isStale() {
        return !scenes.areReflectionsCurrent();
    }

    /** Whether a picture that differs so much from a full trace of the scenes is as promised. */
    public boolean isMetBy(Difference difference) {
        return bound == 0 ? difference.isNone() : difference.maxAbsolute() <= bound;
    }

    /** {@code exact}, or {@code off by at most 1.2e-06}; and whether the mirrors are older. */
    public String text() {
        return (bound == 0 ? Messages.tr("exact") : Messages.tr("off by at most {0}", number(bound)))
                + (isStale() ? Messages.tr(", reflections out of date") : "");
    }

    /** The {@link #text} of the promise for an update, and whether that computed contributions anew. */
    public String text(UpdateResult update) {
        return text() + (update.wasRefreshed() ? Messages.tr(", recomputed") : "");
    }

    /** By how much values differ at most, linear: two digits, rounded up. */
    static String number(double v) {
        return Double.isInfinite(v) ? "∞"
                : String.format(Locale.ROOT, "%.1e", BigDecimal.valueOf(v).round(new MathContext(2, RoundingMode.UP)));
    }

    /**
     * Compares a picture with full traces, over shapes and a tree of boxes that are made for this alone.
     *
     * @throws CancellationException if {@code progress} asked to stop
     */
    public Verification verify(Film picture, WorkerPool workers, Progress progress) {
        var geometry = new Geometry(scenes.scene());
        RenderedScenes currentScenes = RenderedScenes.of(scenes.scene());
        Film[] full = new Film[1];
        boolean isWarm = Engines.isFastestInUse();
        double milliseconds = InterleavedTimer.timeMs(() -> full[0] = trace(currentScenes, geometry, workers, progress));
        Difference fromFull = Difference.of(picture, full[0]);
        Difference expectedDifference = isStale() ? Difference.of(picture, trace(scenes, geometry, workers, progress)) : fromFull;
        return new Verification(this, picture, full[0], expectedDifference, fromFull,
                isWarm ? OptionalDouble.of(milliseconds) : OptionalDouble.empty());
    }

    /** From nothing: where all effects are shown a full trace that keeps nothing, else a first pass with the same effects. */
    private Film trace(RenderedScenes seenScenes, Geometry geometry, WorkerPool workers, Progress progress) {
        if (view.equals(ViewEffects.ALL)) {
            return new TraditionalTracer(seenScenes.scene(), seenScenes.mirrored(), geometry).trace(workers, progress).film();
        }
        RenderOptions options = RenderOptions.DEFAULT.withAccuracy(Accuracy.EXACT).withReflections(ReflectionMode.STALE).withView(view)
                .withThreads(workers.count());
        try (Renderer renderer = new Renderer(options)) {
            renderer.render(seenScenes.mirrored(), progress);
            renderer.render(seenScenes.scene(), progress);
            return renderer.film();
        }
    }
}
