package lightning.bench.accuracy;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.HeapBudget;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.cache.PixelCache;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.relight.MemoryEstimate;
import lightning.render.shading.RenderedScenes;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;

/**
 * Measures the ladder of an edit: every grade of accuracy, in turns with a full trace.
 *
 * <p>Each grade makes the edit once and is compared with its oracle before anything is timed. Each timed edit starts from
 * what was kept of the scene before it, so none profits from the one before. The full trace gets its tree of boxes for free.
 * Edits that start from the same scene share its first pass; what is kept of it stays in memory until the meter is closed.
 */
public final class AccuracySweepMeter implements AutoCloseable {
    private final WorkerPool workers;
    private final InterleavedTimer timer;
    private final List<SettingRenderer> renderers = new ArrayList<>();
    private Scene startScene;
    private PixelCache startCache;

    /**
     * @param threads     how many threads each grade works with, ≥ 1
     * @param repetitions how often each grade is measured, ≥ 1
     * @param maxWarmUpMs  how long warming up takes at most, milliseconds
     * @throws IllegalArgumentException if {@code threads} or {@code repetitions} is below 1
     */
    public AccuracySweepMeter(int threads, int repetitions, double maxWarmUpMs) {
        this(threads, new InterleavedTimer(repetitions, maxWarmUpMs));
    }

    /** A meter for a Java that has not run for long, as an editor's: works must be steady for a while. */
    public static AccuracySweepMeter untilSteady(int threads, int repetitions, double maxWarmUpMs) {
        return new AccuracySweepMeter(threads, new InterleavedTimer(repetitions, maxWarmUpMs, WarmSaving.STEADY_MS));
    }

    private AccuracySweepMeter(int threads, InterleavedTimer timer) {
        this.timer = timer;
        workers = new WorkerPool(threads);
        for (AccuracySetting setting : AccuracySetting.values()) {
            if (setting != AccuracySetting.FULL_TRACE) {
                renderers.add(new SettingRenderer(setting, workers));
            }
        }
    }

    /**
     * Measures the edit that leads from one scene to another.
     *
     * @param progress hears of finished rounds
     * @throws GuaranteeViolation if a grade's picture is not what it promises
     * @throws java.util.concurrent.CancellationException if {@code progress} asked to stop
     */
    public AccuracySweep measure(Scene before, Scene after, Progress progress) {
        Progress silent = progress.cancellationOnly();
        prepare(before, silent);
        List<SettingRenderer> renderers = this.renderers.stream().filter(renderer -> renderer.setting().appliesTo(before)).toList();
        for (SettingRenderer renderer : renderers) {
            renderer.applyEdit(after, silent);
            renderer.verify(silent);
        }
        var tracer = new TraditionalTracer(after, this.renderers.getLast().geometry()).withEngines(Engines.FASTEST);
        TraditionalTracer.Result full = tracer.trace(workers, silent);
        // What shows the scene as it is must be the very picture that it is measured beside.
        var currentGuarantee = new AccuracyGuarantee(RenderedScenes.of(after), ViewEffects.ALL, 0);
        renderers.stream().filter(
                renderer -> renderer.setting() == AccuracySetting.EXACT_UPDATED || renderer.setting() == AccuracySetting.EXACT_CURRENT)
                .forEach(renderer -> GuaranteeViolation.require(currentGuarantee.verify(renderer.film(), workers, silent),
                        renderer.setting()));
        List<InterleavedTimer.TimedTask<RuntimeException>> tasks = new ArrayList<>();
        renderers.forEach(renderer -> tasks.add(() -> renderer.applyEdit(after, silent)));
        tasks.add(() -> InterleavedTimer.timeMs(() -> tracer.trace(workers, silent)));
        boolean isWarm = timer.warmUp(tasks, silent);
        List<Timing> times = timer.measure(tasks, progress);
        return new AccuracySweep(before, after, startCache.film(), points(renderers, times, full.film(), silent), full.rays(), isWarm);
    }

    /** What is kept of the scene that the last measured edit started from. */
    public PixelCache startCache() {
        return startCache;
    }

    private void prepare(Scene before, Progress progress) {
        if (before.equals(startScene)) {
            return;
        }
        startScene = null;
        startCache = null;
        // The grades' pictures lie in memory beside each other.
        long memory = HeapBudget.availableBytes();
        for (SettingRenderer renderer : renderers.stream().filter(g -> g.setting().appliesTo(before)).toList()) {
            if (renderer.setting().startsFromExact()) {
                renderer.startFrom(startCache);
            } else {
                PixelCache cache = renderer.renderStart(before, memory, progress);
                memory -= MemoryEstimate.usedBytes(cache);
                startCache = renderer.setting() == AccuracySetting.EXACT ? cache : startCache;
            }
        }
        startScene = before;
    }

    private List<SweepPoint> points(List<SettingRenderer> renderers, List<Timing> times, Film reference, Progress progress) {
        PictureError[] errors = new PictureError[renderers.size()];
        workers.run(errors.length, (_, i) -> errors[i] = PictureError.of(renderers.get(i).film(), reference), progress);
        List<SweepPoint> points = new ArrayList<>();
        for (int i = 0; i < errors.length; i++) {
            SettingRenderer renderer = renderers.get(i);
            points.add(new SweepPoint(renderer.setting(), times.get(i), errors[i], renderer.film(), renderer.update()));
        }
        points.add(new SweepPoint(AccuracySetting.FULL_TRACE, times.getLast(), PictureError.of(reference, reference), reference, null));
        return points;
    }

    @Override
    public void close() {
        renderers.forEach(SettingRenderer::close);
        workers.close();
    }
}
