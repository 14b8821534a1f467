package lightning.bench;

import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.scene.Scene;

/**
 * How fast a scene is traced in full here: what predictions are made of.
 *
 * <p>The factors were fitted to runs on two cores; a prediction is good to about a factor of two.
 *
 * @param msPerPixel milliseconds
 */
record TraceThroughput(double msPerPixel) {
    private static final PictureSize TRACE_SIZE = new PictureSize(320, 240);
    /** It traces until so many traces were not notably faster than the best before: the compiler is done. */
    private static final int STEADY_TRACES = 12;
    private static final double FASTER_FACTOR = 0.9;
    /** How many times the least time it waits for that. */
    private static final double MAX_TIME_FACTOR = 5;
    /** Warming up takes so many rounds, as a rule. */
    private static final double WARM_UP_ROUNDS = 3;
    /** One round of a ladder in full traces: the trace, and re-renders of all kinds. */
    private static final double SWEEP_ROUND = 1.5;
    /** Comparing the grades with their oracles, in full traces. */
    private static final double SWEEP_CHECK = 6;
    /** What a ladder takes however small its pictures are, milliseconds: code that is met for the first time, files. */
    private static final double SWEEP_MIN_MS = 120;
    /** The same of an effect, which has works of its own to warm up. */
    private static final double EFFECT_MIN_MS = 2500;
    /** Measuring how far a ladder's pictures are off, milliseconds a pixel. */
    private static final double ERROR_MS_PER_PIXEL = 0.7e-3;

    /**
     * Traces small pictures until they are fast; in cold code that takes a while.
     *
     * @param minMs for how long at least, milliseconds: the compiler takes its time
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

    /** So many effects, each in turns with the picture as it is, in the first pass and an update. */
    double effectsMs(PictureSize size, int repetitions, int effects) {
        return (fullMs(size) * 2.5 * (WARM_UP_ROUNDS + repetitions) + EFFECT_MIN_MS) * effects;
    }

    /** So many edits and a full trace in turns. */
    double updatesMs(PictureSize size, int repetitions, int edits) {
        return fullMs(size) * ((WARM_UP_ROUNDS + repetitions) * (1 + 0.2 * edits) + 2 * edits);
    }
}
