package lightning.bench.accuracy;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.render.cache.PixelCache;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.relight.Renderer;
import lightning.render.relight.Update;
import lightning.render.relight.tile.Options;
import lightning.render.shading.TraceCounts;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;

/**
 * Measures updates beside full traces, in turns, so that whatever slows the machine for a while slows both.
 *
 * <p>Each update starts from what was kept of the scene before it. The full trace gets its tree of boxes for free.
 */
public final class SavingMeter implements AutoCloseable {
    /** A test that asks for no times sets 0: each edit once. */
    private static final long WARM_UP_NANOSECONDS = TimeUnit.MILLISECONDS.toNanos(Long.getLong("lightning.warmup", 4000));
    /** A process on a busy machine may still compile then: it gets so long at most. */
    private static final long LONGEST_WARM_UP_NANOSECONDS = 15 * WARM_UP_NANOSECONDS / 2;
    private static final Compilers COMPILERS = Compilers.ofJava();

    private final Renderer renderer;
    private final Workers workers;
    private final Turns turns;
    private final double bytesPerMs;

    /**
     * A meter that measures the bandwidth of memory first.
     *
     * @param repetitions how often each is measured, ≥ 1
     * @throws IllegalArgumentException if it is below 1
     */
    public SavingMeter(Options options, int repetitions) {
        turns = new Turns(repetitions);
        renderer = new Renderer(options.withEngines(Engines.FASTEST));
        workers = new Workers(options.threads());
        bytesPerMs = Bandwidth.bytesPerMs(workers);
    }

    /**
     * A meter for which the bandwidth of memory is known.
     *
     * @param repetitions how often each is measured, ≥ 1
     * @param patienceMs  how long warming up takes at most, milliseconds
     * @param bytesPerMs  bytes in a millisecond that memory can read and write
     * @throws IllegalArgumentException if {@code repetitions} is below 1
     */
    public SavingMeter(Options options, int repetitions, double patienceMs, double bytesPerMs) {
        turns = new Turns(repetitions, patienceMs);
        renderer = new Renderer(options.withEngines(Engines.FASTEST));
        workers = new Workers(options.threads());
        this.bytesPerMs = bytesPerMs;
    }

    /** The renderer that is measured: after {@link #update} it shows the scene after the update. */
    public Renderer renderer() {
        return renderer;
    }

    /** Bytes in a millisecond that memory can read and write. */
    public double bytesPerMs() {
        return bytesPerMs;
    }

    /**
     * Measures the first pass of a scene.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} asked to stop
     */
    public FirstPassCost firstPass(Scene scene, Progress progress) {
        TraditionalTracer tracer = new TraditionalTracer(scene).by(Engines.FASTEST);
        Taken times = take(List.of(() -> {
            try (Renderer fresh = new Renderer(renderer.options())) {
                return fresh.render(scene, progress).milliseconds();
            }
        }, () -> Turns.time(() -> tracer.trace(workers, progress))), progress);
        renderer.render(scene, progress);
        long bytes = renderer.cache().bytes();
        return new FirstPassCost(times.of(0), times.of(1), tracer.trace(workers, progress.silent()).rays().all(),
                renderer.cache().rowCount(), bytes, bytes / bytesPerMs, times.warm());
    }

    /**
     * Measures the update from one scene to another, and verifies its picture.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} asked to stop
     */
    public Saving update(Scene before, Scene after, Progress progress) {
        settle(before, progress);
        return measure(List.of(() -> renderer.render(after, progress)), after, progress).getFirst();
    }

    /**
     * Measures several updates that start from one scene, all in turns with each other and with a full trace of that scene, and
     * verifies their pictures.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} asked to stop
     */
    public List<Saving> updates(Scene before, List<Scene> afters, Progress progress) {
        settle(before, progress);
        List<Supplier<Update>> works = new ArrayList<>();
        afters.forEach(after -> works.add(() -> renderer.render(after, progress)));
        return measure(works, before, progress);
    }

    /**
     * Measures the update of the reflections after an edit (paper §4.8), and verifies its picture.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} asked to stop
     */
    public Saving reflections(Scene before, Scene after, Progress progress) {
        settle(before, progress);
        renderer.render(after, progress);
        return measure(List.of(() -> renderer.updateReflections(progress)), after, progress).getFirst();
    }

    /** Times of works, and whether Java's compilers rested while they were taken. */
    private record Taken(List<Timing> times, boolean warm) {
        Timing of(int work) {
            return times.get(work);
        }
    }

    private Taken take(List<Turns.Turn<RuntimeException>> works, Progress progress) {
        turns.warmUp(works, progress.silent());
        Compilers.Watch watch = COMPILERS.watch();
        List<Timing> times = turns.measure(works, progress.silent());
        return new Taken(times, watch.isResting());
    }

    /** Measures works that start, each time, from what the renderer keeps now; the scene is traced in full beside them. */
    private List<Saving> measure(List<Supplier<Update>> works, Scene traced, Progress progress) {
        PixelCache start = renderer.cache();
        List<Update> updates = new ArrayList<>();
        List<Boolean> kept = new ArrayList<>();
        List<Turns.Turn<RuntimeException>> turn = new ArrayList<>();
        for (Supplier<Update> work : works) {
            renderer.restore(start);
            updates.add(work.get());
            kept.add(Promise.of(renderer, updates.getLast()).verify(renderer.film(), workers, progress).isKept());
            turn.add(() -> {
                renderer.restore(start);
                return work.get().milliseconds();
            });
        }
        TraditionalTracer tracer = tracer(traced);
        TraceCounts fullRays = tracer.trace(workers, progress).rays();
        turn.add(() -> Turns.time(() -> tracer.trace(workers, progress)));
        Taken times = take(turn, progress);
        List<Saving> savings = new ArrayList<>();
        for (int i = 0; i < works.size(); i++) {
            savings.add(new Saving(updates.get(i), times.of(i), times.of(works.size()), fullRays, bytesPerMs, kept.get(i), times.warm()));
        }
        return savings;
    }

    /**
     * Measures a full trace beside another program's.
     *
     * @param rival lets the other program trace the same picture once; returns milliseconds
     * @throws Exception whatever {@code rival} throws, or a CancellationException if {@code progress} asked to stop
     */
    public TurnTimes against(Scene scene, Callable<Double> rival, Progress progress) throws Exception {
        var tracer = new TraditionalTracer(scene).by(Engines.FASTEST);
        List<Timing> times = turns.<Exception>take(List.of(() -> Turns.time(() -> tracer.trace(workers, progress)), rival::call),
                progress.silent());
        return new TurnTimes(times.get(0), times.get(1));
    }

    /** The full trace of a scene, by the tree of boxes that is known where it holds the scene's shapes. */
    private TraditionalTracer tracer(Scene scene) {
        Geometry known = renderer.cache().geometry();
        return (known.serves(scene) ? new TraditionalTracer(scene, known) : new TraditionalTracer(scene)).by(Engines.FASTEST);
    }

    /** Shows a scene, mirrors included, as if nothing had been asked before: no way to a light is known from a later edit. */
    private void settle(Scene scene, Progress progress) {
        renderer.forget();
        renderer.render(scene, progress);
    }

    /**
     * Runs updates and full traces until Java's compilers rest: at least once each and for a few seconds, for half a minute at most.
     *
     * @param edits pairs of scenes, the one before and the one after
     * @throws java.util.concurrent.CancellationException if {@code progress} asked to stop
     */
    public void warmUp(List<Scene[]> edits, Progress progress) {
        long start = System.nanoTime();
        Compilers.Watch watch;
        do {
            watch = COMPILERS.watch();
            for (Scene[] edit : edits) {
                settle(edit[0], progress);
                renderer.render(edit[1], progress);
                tracer(edit[1]).trace(workers, progress);
            }
        } while (!edits.isEmpty() && System.nanoTime() - start < (watch.isResting() ? WARM_UP_NANOSECONDS : LONGEST_WARM_UP_NANOSECONDS));
    }

    @Override
    public void close() {
        renderer.close();
        workers.close();
    }
}
