package lightning.bench.accuracy;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.measure.AccuracyGuarantee;
import lightning.render.measure.InterleavedTimer;
import lightning.render.measure.Timing;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.shading.RayCounts;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;

/**
 * Meter of updates in turns with full traces, so that a temporary slowdown of the machine affects both.
 *
 * <p>Each update starts from the cache of the original scene. The full trace does not include building its BVH.
 */
public final class UpdateSavingMeter implements AutoCloseable {
    /** Minimum warm-up. Functional tests set 0: each edit once, and each measurement after two rounds. */
    private static final long WARM_UP_MS = Long.getLong("lightning.warmup", 4000);
    private static final long WARM_UP_NANOSECONDS = TimeUnit.MILLISECONDS.toNanos(WARM_UP_MS);
    /** Maximum warm-up, for busy machines on which the compilers need longer. */
    private static final long MAX_WARM_UP_NANOSECONDS = 15 * WARM_UP_NANOSECONDS / 2;
    private static final CompilerActivity COMPILERS = CompilerActivity.ofVm();

    private final Renderer renderer;
    private final WorkerPool workers;
    private final InterleavedTimer timer;
    private final double bytesPerMs;

    /**
     * Creates a meter that first measures memory bandwidth.
     *
     * @param repetitions number of measurements of each, ≥ 1
     * @throws IllegalArgumentException if it is below 1
     */
    public UpdateSavingMeter(RenderOptions options, int repetitions) {
        timer = new InterleavedTimer(repetitions, Math.min(WARM_UP_MS, InterleavedTimer.MAX_WARM_UP_MS));
        renderer = new Renderer(options.withEngines(Engines.FASTEST));
        workers = new WorkerPool(options.threads());
        bytesPerMs = MemoryBandwidth.bytesPerMs(workers);
    }

    /**
     * Creates a meter with a known memory bandwidth.
     *
     * @param repetitions number of measurements of each, ≥ 1
     * @param maxWarmUpMs maximum warm-up, milliseconds
     * @param bytesPerMs  memory bandwidth, bytes read and written per millisecond
     * @throws IllegalArgumentException if {@code repetitions} is below 1
     */
    public UpdateSavingMeter(RenderOptions options, int repetitions, double maxWarmUpMs, double bytesPerMs) {
        timer = new InterleavedTimer(repetitions, maxWarmUpMs);
        renderer = new Renderer(options.withEngines(Engines.FASTEST));
        workers = new WorkerPool(options.threads());
        this.bytesPerMs = bytesPerMs;
    }

    /** Returns the measured renderer. After {@link #update} it shows the scene after the update. */
    public Renderer renderer() {
        return renderer;
    }

    /** Returns the memory bandwidth in bytes read and written per millisecond. */
    public double bytesPerMs() {
        return bytesPerMs;
    }

    /**
     * Measures the first pass of a scene.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} requests a stop
     */
    public FirstPassCost firstPass(Scene scene, Progress progress) {
        TraditionalTracer tracer = new TraditionalTracer(scene).withEngines(Engines.FASTEST);
        MeasuredTimes times = warmUpAndMeasure(List.of(() -> {
            try (Renderer newRenderer = new Renderer(renderer.options())) {
                return newRenderer.render(scene, progress).milliseconds();
            }
        }, () -> InterleavedTimer.timeMs(() -> tracer.trace(workers, progress))), progress);
        renderer.render(scene, progress);
        long bytes = renderer.cache().bytes();
        return new FirstPassCost(times.get(0), times.get(1), tracer.trace(workers, progress.cancellationOnly()).rays().total(),
                renderer.cache().rowCount(), bytes, bytes / bytesPerMs, times.isWarm());
    }

    /**
     * Measures the update from one scene to another, and verifies its image.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} requests a stop
     */
    public UpdateSaving update(Scene before, Scene after, Progress progress) {
        renderFresh(before, progress);
        return measure(List.of(() -> renderer.render(after, progress)), after, progress).getFirst();
    }

    /**
     * Measures several updates from one scene in turns with each other and with a full trace of that scene, and verifies their images.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} requests a stop
     */
    public List<UpdateSaving> updates(Scene before, List<Scene> afters, Progress progress) {
        renderFresh(before, progress);
        List<Supplier<UpdateResult>> updateTasks = new ArrayList<>();
        afters.forEach(after -> updateTasks.add(() -> renderer.render(after, progress)));
        return measure(updateTasks, before, progress);
    }

    /**
     * Measures the update of reflections after an edit (paper §4.8), and verifies its image.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} requests a stop
     */
    public UpdateSaving reflections(Scene before, Scene after, Progress progress) {
        renderFresh(before, progress);
        renderer.render(after, progress);
        return measure(List.of(() -> renderer.updateReflections(progress)), after, progress).getFirst();
    }

    /** Times of tasks, and whether the JIT compilers were idle meanwhile. */
    private record MeasuredTimes(List<Timing> times, boolean isWarm) {
        Timing get(int work) {
            return times.get(work);
        }
    }

    private MeasuredTimes warmUpAndMeasure(List<InterleavedTimer.TimedTask<RuntimeException>> tasks, Progress progress) {
        timer.warmUp(tasks, progress.cancellationOnly());
        CompilerActivity.CompilerWatch watch = COMPILERS.startWatch();
        List<Timing> times = timer.measure(tasks, progress.cancellationOnly());
        return new MeasuredTimes(times, watch.isIdle());
    }

    /** Measures tasks that each start from the renderer's current cache, in turns with a full trace of the scene. */
    private List<UpdateSaving> measure(List<Supplier<UpdateResult>> updateTasks, Scene tracedScene, Progress progress) {
        PixelCache start = renderer.cache();
        List<UpdateResult> updates = new ArrayList<>();
        List<Boolean> verified = new ArrayList<>();
        List<InterleavedTimer.TimedTask<RuntimeException>> tasks = new ArrayList<>();
        for (Supplier<UpdateResult> work : updateTasks) {
            renderer.restore(start);
            updates.add(work.get());
            verified.add(AccuracyGuarantee.of(renderer, updates.getLast()).verify(renderer.film(), workers, progress).hasPassed());
            tasks.add(() -> {
                renderer.restore(start);
                return work.get().milliseconds();
            });
        }
        TraditionalTracer tracer = tracer(tracedScene);
        RayCounts fullRays = tracer.trace(workers, progress).rays();
        tasks.add(() -> InterleavedTimer.timeMs(() -> tracer.trace(workers, progress)));
        MeasuredTimes times = warmUpAndMeasure(tasks, progress);
        List<UpdateSaving> savings = new ArrayList<>();
        for (int i = 0; i < updateTasks.size(); i++) {
            savings.add(new UpdateSaving(updates.get(i), times.get(i), times.get(updateTasks.size()), fullRays, bytesPerMs, verified.get(i),
                    times.isWarm()));
        }
        return savings;
    }

    /**
     * Measures a full trace in turns with another program.
     *
     * @param rival lets the other program trace the same image once; returns milliseconds
     * @throws Exception any exception of {@code rival}, or a CancellationException if {@code progress} requests a stop
     */
    public RivalTiming compareWith(Scene scene, Callable<Double> rival, Progress progress) throws Exception {
        var tracer = new TraditionalTracer(scene).withEngines(Engines.FASTEST);
        List<Timing> times = timer.<Exception>warmUpAndMeasure(
                List.of(() -> InterleavedTimer.timeMs(() -> tracer.trace(workers, progress)), rival::call),
                progress.cancellationOnly());
        return new RivalTiming(times.get(0), times.get(1));
    }

    /** Returns a full tracer of a scene, reusing the known BVH if it contains the scene's shapes. */
    private TraditionalTracer tracer(Scene scene) {
        Geometry cachedGeometry = renderer.cache().geometry();
        return (cachedGeometry.canServe(scene) ? new TraditionalTracer(scene, cachedGeometry) : new TraditionalTracer(scene))
                .withEngines(Engines.FASTEST);
    }

    /** Renders a scene with current reflections from scratch, so that no shadow ray is cached from a later edit. */
    private void renderFresh(Scene scene, Progress progress) {
        renderer.clear();
        renderer.render(scene, progress);
    }

    /**
     * Runs updates and full traces until the JIT compilers are idle: at least once each and for a few seconds, at most half a minute.
     *
     * @param edits pairs of scenes, before and after each edit
     * @throws java.util.concurrent.CancellationException if {@code progress} requests a stop
     */
    public void warmUp(List<Scene[]> edits, Progress progress) {
        long start = System.nanoTime();
        CompilerActivity.CompilerWatch watch;
        do {
            watch = COMPILERS.startWatch();
            for (Scene[] edit : edits) {
                renderFresh(edit[0], progress);
                renderer.render(edit[1], progress);
                tracer(edit[1]).trace(workers, progress);
            }
        } while (!edits.isEmpty() && System.nanoTime() - start < (watch.isIdle() ? WARM_UP_NANOSECONDS : MAX_WARM_UP_NANOSECONDS));
    }

    @Override
    public void close() {
        renderer.close();
        workers.close();
    }
}
