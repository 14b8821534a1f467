package lightning.bench.accuracy;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.render.cache.PixelCache;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.relight.Renderer;
import lightning.render.relight.Update;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.Options;

/**
 * What an update saves of a full trace of the very picture that it led to, measured when Java was warm to both. An edit is made
 * once, and often in code that never ran before, so its own time beside a trace's that ran a hundred times would tell how cold
 * the code was. It is therefore made again, from what was known before it, in turns with the trace.
 *
 * @param of     the update that it is a saving of
 * @param update milliseconds of the update, made again; likewise {@code full}, of the trace
 */
public record WarmSaving(Update of, Timing update, Timing full) {
    /** How long no turn may have become faster, milliseconds of work, before both count as warm. */
    static final double STEADY_MS = 300;
    private static final int REPETITIONS = 5;

    /** What was done, for a renderer to do again. */
    @FunctionalInterface
    public interface Step {
        Update on(Renderer renderer, Progress progress);
    }

    /**
     * An update that can be made again.
     *
     * @param made    what it did
     * @param start   what was known before it, of the same accuracy
     * @param options how it was made
     * @param step    made it
     */
    public record Edit(Update made, PixelCache start, Options options, Step step) {

        /** Empty where there is nothing to save: the picture was traced for the first time, or was there already. */
        public static Optional<Edit> of(Update made, PixelCache start, Options options, Step step) {
            return start == null || !(made.plan() instanceof UpdatePlan.Relight) ? Optional.empty()
                    : Optional.of(new Edit(made, start, options, step));
        }
    }

    /**
     * Measures a saving. The trace gets its tree of boxes for free.
     *
     * @param workers    of the trace; the update has its own, as many as its options say
     * @param patienceMs how long warming up takes at most, milliseconds of the own work of who calls
     * @return empty where that was too short for Java to get warm
     * @throws CancellationException if {@code progress} asked to stop
     */
    public static Optional<WarmSaving> measure(Edit edit, Workers workers, double patienceMs, Progress progress) {
        Progress silent = progress.silent();
        try (var renderer = new Renderer(edit.options().withEngines(Engines.FASTEST))) {
            again(edit, renderer, silent);
            var tracer = new TraditionalTracer(renderer.scene(), renderer.cache().geometry()).by(Engines.FASTEST);
            List<Turns.Turn<RuntimeException>> works = List.of(() -> again(edit, renderer, silent),
                    () -> Turns.time(() -> tracer.trace(workers, silent)));
            var turns = new Turns(REPETITIONS, patienceMs, STEADY_MS);
            if (!turns.warmUp(works, silent)) {
                return Optional.empty();
            }
            List<Timing> times = turns.measure(works, silent);
            return Optional.of(new WarmSaving(edit.made(), times.getFirst(), times.getLast()));
        }
    }

    private static double again(Edit edit, Renderer renderer, Progress progress) {
        renderer.restore(edit.start());
        return edit.step().on(renderer, progress).milliseconds();
    }

    /** Whether it is a saving of this update, and no other that did the same. */
    public boolean isOf(Update shown) {
        return of == shown;
    }

    /** Percent of the full trace's time; negative where the update takes longer. */
    public double percent() {
        return update.savingOf(full.median());
    }
}
