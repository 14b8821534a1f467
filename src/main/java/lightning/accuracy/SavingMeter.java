package lightning.accuracy;

import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.Supplier;
import lightning.image.Difference;
import lightning.relight.Accuracy;
import lightning.relight.Options;
import lightning.relight.Renderer;
import lightning.relight.Update;
import lightning.scene.Scene;
import lightning.shading.Progress;
import lightning.shading.TraceCounts;
import lightning.shading.TraditionalTracer;
import lightning.shading.Workers;
import lightning.trace.Geometry;

/**
 * Measures updates beside full traces, in turns, so that whatever slows the machine for a while slows both.
 *
 * <p>Each measurement warms up, then repeats (first pass, update, full trace) and takes medians. The full trace gets its tree
 * of boxes for free.
 */
public final class SavingMeter implements AutoCloseable {
    private static final int WARM_UPS = 2;
    /** The first pass comes first, in cold code. */
    private static final int FIRST_WARM_UPS = 6;
    private static final long WARM_UP_NANOSECONDS = 4_000_000_000L;

    private final Renderer renderer;
    private final Workers workers;
    private final int repetitions;
    private final double bytesPerMs;

    /**
     * @param repetitions how often each is measured, ≥ 1
     * @throws IllegalArgumentException if it is below 1
     */
    public SavingMeter(Options options, int repetitions) {
        if (repetitions < 1) {
            throw new IllegalArgumentException("the number of repetitions must be ≥ 1, was " + repetitions);
        }
        this.repetitions = repetitions;
        renderer = new Renderer(options);
        workers = new Workers(options.threads());
        bytesPerMs = Bandwidth.bytesPerMs(workers);
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
        double[] first = new double[repetitions];
        double[] full = new double[repetitions];
        TraditionalTracer tracer = new TraditionalTracer(scene);
        for (int i = -FIRST_WARM_UPS; i < repetitions; i++) {
            try (Renderer fresh = new Renderer(renderer.options())) {
                first[Math.max(i, 0)] = fresh.render(scene, progress).milliseconds();
            }
            full[Math.max(i, 0)] = milliseconds(() -> tracer.trace(workers, progress));
        }
        renderer.render(scene, progress);
        long bytes = renderer.cache().bytes();
        return new FirstPassCost(median(first), median(full), renderer.cache().rowCount(), bytes, bytes / bytesPerMs);
    }

    /**
     * Measures the update from one scene to another, and verifies its picture.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} asked to stop
     */
    public Saving update(Scene before, Scene after, Progress progress) {
        return measure(() -> settle(before, progress), () -> renderer.render(after, progress), after, progress);
    }

    /**
     * Measures the update of the reflections after an edit (paper §4.8), and verifies its picture.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} asked to stop
     */
    public Saving reflections(Scene before, Scene after, Progress progress) {
        return measure(() -> {
            settle(before, progress);
            renderer.render(after, progress);
        }, () -> renderer.updateReflections(progress), after, progress);
    }

    private Saving measure(Runnable before, Supplier<Update> work, Scene after, Progress progress) {
        before.run();
        Update update = work.get();
        boolean kept = isKept(update, progress);
        var tracer = new TraditionalTracer(after, renderer.cache().geometry());
        TraceCounts fullRays = tracer.trace(workers, progress).rays();
        double[] updates = new double[repetitions];
        double[] fulls = new double[repetitions];
        for (int i = -WARM_UPS; i < repetitions; i++) {
            before.run();
            updates[Math.max(i, 0)] = work.get().milliseconds();
            fulls[Math.max(i, 0)] = milliseconds(() -> tracer.trace(workers, progress));
        }
        double full = median(fulls);
        return new Saving(update, median(updates), full, fullRays, cap(update, full, fullRays), kept);
    }

    /**
     * Measures a full trace beside another program's.
     *
     * @param rival lets the other program trace the same picture once; returns milliseconds
     * @throws Exception whatever {@code rival} throws, or a CancellationException if {@code progress} asked to stop
     */
    public TurnTimes against(Scene scene, Callable<Double> rival, Progress progress) throws Exception {
        var tracer = new TraditionalTracer(scene);
        double[] full = new double[repetitions];
        double[] other = new double[repetitions];
        for (int i = -WARM_UPS; i < repetitions; i++) {
            full[Math.max(i, 0)] = milliseconds(() -> tracer.trace(workers, progress));
            other[Math.max(i, 0)] = rival.call();
        }
        return new TurnTimes(median(full), median(other));
    }

    /** Shows a scene, mirrors included, as if nothing had been asked before: no way to a light is known from a later edit. */
    private void settle(Scene scene, Progress progress) {
        renderer.forget();
        renderer.render(scene, progress);
    }

    private boolean isKept(Update update, Progress progress) {
        Scene scene = renderer.scene();
        Geometry geometry = renderer.cache().geometry();
        var oracle = new TraditionalTracer(scene, renderer.cache().mirroredScene(), geometry).trace(workers, progress).film();
        return renderer.options().accuracy() == Accuracy.EXACT || update.errorBound() == 0
                ? renderer.film().sameBits(oracle)
                : Difference.of(renderer.film(), oracle).maxAbsolute() <= update.errorBound();
    }

    private double cap(Update update, double fullMs, TraceCounts fullRays) {
        double rays = fullMs * update.rays().all() / fullRays.all();
        return 100 * (1 - Math.max(rays, update.bytesMoved() / bytesPerMs) / fullMs);
    }

    /**
     * Runs updates and full traces until the compiler has seen them: at least once each, and for a few seconds.
     *
     * @param edits pairs of scenes, the one before and the one after
     * @throws java.util.concurrent.CancellationException if {@code progress} asked to stop
     */
    public void warmUp(List<Scene[]> edits, Progress progress) {
        long start = System.nanoTime();
        do {
            for (Scene[] edit : edits) {
                settle(edit[0], progress);
                renderer.render(edit[1], progress);
                new TraditionalTracer(edit[1], renderer.cache().geometry()).trace(workers, progress);
            }
        } while (!edits.isEmpty() && System.nanoTime() - start < WARM_UP_NANOSECONDS);
    }

    private static double milliseconds(Runnable work) {
        long start = System.nanoTime();
        work.run();
        return (System.nanoTime() - start) / 1e6;
    }

    private static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        int middle = sorted.length / 2;
        return sorted.length % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
    }

    @Override
    public void close() {
        renderer.close();
        workers.close();
    }
}
