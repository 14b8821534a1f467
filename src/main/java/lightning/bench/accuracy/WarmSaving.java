package lightning.bench.accuracy;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.cache.PixelCache;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.RenderOptions;

/**
 * What an update saves of a full trace of the very picture that it led to, measured when Java was warm to both. An edit is made
 * once, and often in code that never ran before, so its own time beside a trace's that ran a hundred times would tell how cold
 * the code was. It is therefore made again, from what was known before it, in turns with the trace.
 *
 * @param measuredUpdate     the update that it is a saving of
 * @param update milliseconds of the update, made again; likewise {@code full}, of the trace
 */
public record WarmSaving(UpdateResult measuredUpdate, Timing update, Timing full) {
    /** How long no turn may have become faster, milliseconds of work, before both count as warm. */
    static final double STEADY_MS = 300;
    private static final int REPETITIONS = 5;

    /** What was done, for a renderer to do again. */
    @FunctionalInterface
    public interface UpdateStep {
        UpdateResult run(Renderer renderer, Progress progress);
    }

    /**
     * An update that can be made again.
     *
     * @param update    what it did
     * @param start   what was known before it, of the same accuracy
     * @param options how it was made
     * @param step    made it
     */
    public record RepeatableEdit(UpdateResult update, PixelCache start, RenderOptions options, UpdateStep step) {

        /** Empty where there is nothing to save: the picture was traced for the first time, or was there already. */
        public static Optional<RepeatableEdit> of(UpdateResult update, PixelCache start, RenderOptions options, UpdateStep step) {
            return start == null || !(update.plan() instanceof UpdatePlan.Relight) ? Optional.empty()
                    : Optional.of(new RepeatableEdit(update, start, options, step));
        }
    }

    /**
     * Measures a saving. The trace gets its tree of boxes for free.
     *
     * @param workers    of the trace; the update has its own, as many as its options say
     * @param maxWarmUpMs how long warming up takes at most, milliseconds of the own work of who calls
     * @return empty where that was too short for Java to get warm
     * @throws CancellationException if {@code progress} asked to stop
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

    /** Whether it is a saving of this update, and no other that did the same. */
    public boolean isOf(UpdateResult shownUpdate) {
        return measuredUpdate == shownUpdate;
    }

    /** Percent of the full trace's time; negative where the update takes longer. */
    public double percent() {
        return update.percentSavedOf(full.median());
    }
}
