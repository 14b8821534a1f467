package lightning.render.measure;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.concurrent.CancellationException;
import lightning.base.text.Messages;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Difference;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.shading.RenderedScenes;
import lightning.render.trace.Geometry;
import lightning.scene.effects.ViewEffects;

/**
 * Accuracy guarantee of an image, shared by the status line, Verify, {@code relight --verify}, the benchmark and the tests.
 *
 * @param scenes scenes of the image and of its reflections
 * @param view   shown effects; all of them in a full image
 * @param bound  maximum error of a value, linear, finite; 0 if the image is bit-identical to a full trace of the scenes
 */
public record AccuracyGuarantee(RenderedScenes scenes, ViewEffects view, double bound) {

    /** Returns the guarantee of a renderer's last update. */
    public static AccuracyGuarantee of(Renderer renderer, UpdateResult update) {
        return new AccuracyGuarantee(renderer.cache().scenes(), renderer.options().view(), update.errorBound());
    }

    /** Returns whether reflections show an older scene that differs visibly. */
    public boolean isStale() {
        return !scenes.areReflectionsCurrent();
    }

    /** Returns whether a difference from a full trace of the scenes satisfies the guarantee. */
    public boolean isMetBy(Difference difference) {
        return bound == 0 ? difference.isNone() : difference.maxAbsolute() <= bound;
    }

    /** Returns {@code exact} or {@code off by at most 1.2e-06}, with a note if reflections are out of date. */
    public String text() {
        return (bound == 0 ? Messages.tr("exact") : Messages.tr("off by at most {0}", number(bound)))
                + (isStale() ? Messages.tr(", reflections out of date") : "");
    }

    /** Returns the {@link #text}, with a note if the update recomputed contributions. */
    public String text(UpdateResult update) {
        return text() + (update.wasRefreshed() ? Messages.tr(", recomputed") : "");
    }

    /** Formats a maximum difference, linear, with two digits rounded up. */
    static String number(double v) {
        return Double.isInfinite(v) ? "∞"
                : String.format(Locale.ROOT, "%.1e", BigDecimal.valueOf(v).round(new MathContext(2, RoundingMode.UP)));
    }

    /**
     * Compares an image with full traces, using separate primitives and a separate BVH.
     *
     * @throws CancellationException if {@code progress} requests a stop
     */
    public Verification verify(Film picture, WorkerPool workers, Progress progress) {
        var geometry = Geometry.of(scenes.scene());
        RenderedScenes currentScenes = RenderedScenes.of(scenes.scene());
        Film[] full = new Film[1];
        boolean isWarm = Engines.isFastestInUse();
        double milliseconds = InterleavedTimer.timeMs(() -> full[0] = trace(currentScenes, geometry, workers, progress));
        Difference fromFull = Difference.of(picture, full[0]);
        Difference expectedDifference = isStale() ? Difference.of(picture, trace(scenes, geometry, workers, progress)) : fromFull;
        return new Verification(this, picture, full[0], expectedDifference, fromFull,
                isWarm ? OptionalDouble.of(milliseconds) : OptionalDouble.empty());
    }

    /** Traces from scratch: a full trace without a cache if all effects are shown, otherwise a first pass with the same effects. */
    private Film trace(RenderedScenes seenScenes, Geometry geometry, WorkerPool workers, Progress progress) {
        if (view.equals(ViewEffects.ALL)) {
            return new TraditionalTracer(seenScenes.scene(), seenScenes.mirrored(), geometry).trace(workers, progress).film();
        }
        RenderOptions options = RenderOptions.DEFAULT.withReflectionsOnRequest().withView(view)
                .withThreads(workers.count());
        try (Renderer renderer = new Renderer(options)) {
            renderer.render(seenScenes.mirrored(), progress);
            renderer.render(seenScenes.scene(), progress);
            return renderer.film();
        }
    }
}
