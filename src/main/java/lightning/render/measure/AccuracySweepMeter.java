package lightning.render.measure;

import static java.util.Objects.requireNonNull;

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
import org.jspecify.annotations.Nullable;

/**
 * Meter of all accuracy settings for an edit, in turns with a full trace.
 *
 * <p>Each setting renders the edit once and is verified before any timing. Each timed edit starts from the cache of the original scene, so
 * that none profits from a previous one. The full trace does not include building its BVH. Edits from the same scene share its first pass,
 * whose cache stays in memory until the meter is closed.
 */
public final class AccuracySweepMeter implements AutoCloseable {
    private final WorkerPool workers;
    private final InterleavedTimer timer;
    private final List<SettingRenderer> renderers = new ArrayList<>();
    private @Nullable Scene startScene;
    private @Nullable PixelCache startCache;

    /**
     * @param threads     number of threads of each setting, ≥ 1
     * @param repetitions number of measurements of each setting, ≥ 1
     * @param maxWarmUpMs maximum warm-up, milliseconds
     * @throws IllegalArgumentException if {@code threads} or {@code repetitions} is below 1
     */
    public AccuracySweepMeter(int threads, int repetitions, double maxWarmUpMs) {
        this(threads, new InterleavedTimer(repetitions, maxWarmUpMs));
    }

    /** Returns a meter for a recently started Java VM, as in an editor: times must be steady for a while. */
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
     * Measures the edit from one scene to another.
     *
     * @param progress receives finished rounds
     * @throws GuaranteeViolation if the image of a setting violates its guarantee
     * @throws java.util.concurrent.CancellationException if {@code progress} requests a stop
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
        // A setting with current reflections must be bit-identical to the reference image.
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
        return new AccuracySweep(before, after, requireNonNull(startCache).film(), points(renderers, times, full.film(), silent),
                full.rays(), isWarm);
    }

    /** Returns the cache of the scene that the last measured edit started from. */
    public @Nullable PixelCache startCache() {
        return startCache;
    }

    private void prepare(Scene before, Progress progress) {
        if (before.equals(startScene)) {
            return;
        }
        startScene = null;
        startCache = null;
        // The images of all settings are in memory together.
        long memory = HeapBudget.availableBytes();
        for (SettingRenderer renderer : renderers.stream().filter(g -> g.setting().appliesTo(before)).toList()) {
            if (renderer.setting().startsFromExact()) {
                renderer.startFrom(requireNonNull(startCache));
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
