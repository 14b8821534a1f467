package lightning.render.measure;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.plan.UpdatePlan;
import org.jspecify.annotations.Nullable;

/**
 * Saving of an update relative to a full trace of its image, measured with warmed-up code. The first run of an edit often executes cold
 * code, so its time is not comparable with that of a trace that ran many times. The edit is therefore repeated from its original cache, in
 * turns with the trace.
 *
 * @param measuredUpdate measured update
 * @param update         milliseconds of the repeated update
 * @param full           milliseconds of the trace
 */
public record WarmSaving(UpdateResult measuredUpdate, Timing update, Timing full) {
    /** Minimum time without improvement, in milliseconds of work, after which both count as warm. */
    static final double STEADY_MS = 300;
    private static final int REPETITIONS = 5;

    /** Update that a renderer can repeat. */
    @FunctionalInterface
    public interface UpdateStep {
        UpdateResult run(Renderer renderer, Progress progress);
    }

    /**
     * Repeatable update.
     *
     * @param update  first run
     * @param start   cache before it, of the same accuracy
     * @param options render options
     * @param step    repeats the update
     */
    public record RepeatableEdit(UpdateResult update, PixelCache start, RenderOptions options, UpdateStep step) {

        /** Returns the repeatable edit; empty for a first pass or an unchanged image, which save nothing. */
        public static Optional<RepeatableEdit> of(UpdateResult update, @Nullable PixelCache start, RenderOptions options, UpdateStep step) {
            return start == null || !(update.plan() instanceof UpdatePlan.Relight) ? Optional.empty()
                    : Optional.of(new RepeatableEdit(update, start, options, step));
        }
    }

    /**
     * Measures a saving. The trace does not include building its BVH.
     *
     * @param workers     workers of the trace; the update has its own, as many as in its options
     * @param maxWarmUpMs maximum warm-up, milliseconds of the calling thread's processor time
     * @return empty if the warm-up limit was too short
     * @throws CancellationException if {@code progress} requests a stop
     */
    public static Optional<WarmSaving> measure(RepeatableEdit edit, WorkerPool workers, double maxWarmUpMs, Progress progress) {
        Progress silent = progress.cancellationOnly();
        try (var renderer = new Renderer(edit.options().withEngines(Engines.FASTEST))) {
            repeat(edit, renderer, silent);
            var tracer = new TraditionalTracer(renderer.scene(), renderer.cache().geometry()).withEngines(Engines.FASTEST);
            List<InterleavedTimer.TimedTask<RuntimeException>> tasks = List.of(() -> repeat(edit, renderer, silent),
                    () -> InterleavedTimer.timeMs(() -> tracer.trace(workers, silent)));
            var timer = new InterleavedTimer(REPETITIONS, maxWarmUpMs, STEADY_MS);
            if (!timer.warmUp(tasks, silent)) {
                return Optional.empty();
            }
            List<Timing> times = timer.measure(tasks, silent);
            return Optional.of(new WarmSaving(edit.update(), times.getFirst(), times.getLast()));
        }
    }

    private static double repeat(RepeatableEdit edit, Renderer renderer, Progress progress) {
        renderer.restore(edit.start());
        return edit.step().run(renderer, progress).milliseconds();
    }

    /** Returns whether it is the saving of this update, by identity. */
    public boolean isOf(@Nullable UpdateResult shownUpdate) {
        return measuredUpdate == shownUpdate;
    }

    /** Returns the saving in percent of the full trace's time; negative if the update is slower. */
    public double percent() {
        return update.percentSavedOf(full.median());
    }
}
