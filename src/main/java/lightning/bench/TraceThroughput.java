package lightning.bench;

import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.scene.Scene;

/**
 * Full-trace speed of a scene on this machine, the basis of predictions.
 *
 * <p>The factors were fitted to runs on two cores; predictions are accurate to about a factor of two.
 *
 * @param msPerPixel milliseconds per pixel
 */
record TraceThroughput(double msPerPixel) {
    private static final PictureSize TRACE_SIZE = new PictureSize(320, 240);
    /** Number of traces without notable improvement after which the JIT compiler counts as finished. */
    private static final int STEADY_TRACES = 12;
    private static final double FASTER_FACTOR = 0.9;
    /** Maximum warm-up, as a multiple of the minimum time. */
    private static final double MAX_TIME_FACTOR = 5;
    /** Typical number of warm-up rounds. */
    private static final double WARM_UP_ROUNDS = 3;
    /** Duration of one round of a sweep in full traces: the trace, and re-renders of all settings. */
    private static final double SWEEP_ROUND = 1.5;
    /** Duration of verifying all settings, in full traces. */
    private static final double SWEEP_CHECK = 6;
    /** Minimum duration of a sweep for any image size, in milliseconds: cold code and files. */
    private static final double SWEEP_MIN_MS = 120;
    /** Minimum duration of an effect's measurement, including its warm-up. */
    private static final double EFFECT_MIN_MS = 2500;
    /** Duration of computing a sweep's image errors, in milliseconds per pixel. */
    private static final double ERROR_MS_PER_PIXEL = 0.7e-3;

    /**
     * Traces small images until times are steady.
     *
     * @param minMs minimum duration for the JIT compiler, milliseconds
     */
    static TraceThroughput measure(Scene scene, WorkerPool workers, double minMs, Progress progress) {
        var tracer = new TraditionalTracer(TRACE_SIZE.of(scene)).withEngines(Engines.FASTEST);
        double best = Double.POSITIVE_INFINITY;
        long start = System.nanoTime();
        double elapsedMs;
        int steadyTraces = 0;
        do {
            long traceStart = System.nanoTime();
            tracer.trace(workers, progress);
            double ms = (System.nanoTime() - traceStart) / 1e6;
            steadyTraces = ms < FASTER_FACTOR * best ? 0 : steadyTraces + 1;
            best = Math.min(best, ms);
            elapsedMs = (System.nanoTime() - start) / 1e6;
        } while (elapsedMs < minMs || steadyTraces < STEADY_TRACES && elapsedMs < MAX_TIME_FACTOR * minMs);
        return new TraceThroughput(best / TRACE_SIZE.pixels());
    }

    double fullMs(PictureSize size) {
        return msPerPixel * size.pixels();
    }

    double sweepMs(PictureSize size, int repetitions) {
        return fullMs(size) * (SWEEP_ROUND * (WARM_UP_ROUNDS + repetitions) + SWEEP_CHECK) + ERROR_MS_PER_PIXEL * size.pixels()
                + SWEEP_MIN_MS;
    }

    double firstPassMs(PictureSize size, int repetitions) {
        return fullMs(size) * 2.2 * (WARM_UP_ROUNDS + repetitions);
    }

    /** Predicts measuring a number of effects, each in turns with the plain image, in the first pass and an update. */
    double effectsMs(PictureSize size, int repetitions, int effects) {
        return (fullMs(size) * 2.5 * (WARM_UP_ROUNDS + repetitions) + EFFECT_MIN_MS) * effects;
    }

    /** Predicts measuring a number of edits in turns with a full trace. */
    double updatesMs(PictureSize size, int repetitions, int edits) {
        return fullMs(size) * ((WARM_UP_ROUNDS + repetitions) * (1 + 0.2 * edits) + 2 * edits);
    }
}
