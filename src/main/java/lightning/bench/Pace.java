package lightning.bench;

import lightning.base.work.Progress;
import lightning.base.work.Workers;
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
record Pace(double msPerPixel) {
    private static final PictureSize SMALL = new PictureSize(320, 240);
    /** It traces until so many traces were not notably faster than the best before: the compiler is done. */
    private static final int STEADY_TRACES = 12;
    private static final double NOTABLY = 0.9;
    /** How many times the least time it waits for that. */
    private static final double PATIENCE = 5;
    /** Warming up takes so many rounds, as a rule. */
    private static final double WARM_UPS = 3;
    /** One round of a ladder in full traces: the trace, and re-renders of all kinds. */
    private static final double LADDER_ROUND = 1.5;
    /** Comparing the grades with their oracles, in full traces. */
    private static final double LADDER_CHECK = 6;
    /** What a ladder takes however small its pictures are, milliseconds: code that is met for the first time, files. */
    private static final double LADDER_LEAST_MS = 120;
    /** The same of an effect, which has works of its own to warm up. */
    private static final double EFFECT_LEAST_MS = 2500;
    /** Measuring how far a ladder's pictures are off, milliseconds a pixel. */
    private static final double ERRORS = 0.7e-3;

    /**
     * Traces small pictures until they are fast; in cold code that takes a while.
     *
     * @param leastMs for how long at least, milliseconds: the compiler takes its time
     */
    static Pace of(Scene scene, Workers workers, double leastMs, Progress progress) {
        var tracer = new TraditionalTracer(SMALL.of(scene)).by(Engines.FASTEST);
        double best = Double.POSITIVE_INFINITY;
        long start = System.nanoTime();
        double ran;
        int steady = 0;
        do {
            long from = System.nanoTime();
            tracer.trace(workers, progress);
            double ms = (System.nanoTime() - from) / 1e6;
            steady = ms < NOTABLY * best ? 0 : steady + 1;
            best = Math.min(best, ms);
            ran = (System.nanoTime() - start) / 1e6;
        } while (ran < leastMs || steady < STEADY_TRACES && ran < PATIENCE * leastMs);
        return new Pace(best / SMALL.pixels());
    }

    double fullMs(PictureSize size) {
        return msPerPixel * size.pixels();
    }

    double ladderMs(PictureSize size, int repetitions) {
        return fullMs(size) * (LADDER_ROUND * (WARM_UPS + repetitions) + LADDER_CHECK) + ERRORS * size.pixels()
                + LADDER_LEAST_MS;
    }

    double firstPassMs(PictureSize size, int repetitions) {
        return fullMs(size) * 2.2 * (WARM_UPS + repetitions);
    }

    /** So many effects, each in turns with the picture as it is, in the first pass and an update. */
    double effectsMs(PictureSize size, int repetitions, int effects) {
        return (fullMs(size) * 2.5 * (WARM_UPS + repetitions) + EFFECT_LEAST_MS) * effects;
    }

    /** So many edits and a full trace in turns. */
    double updatesMs(PictureSize size, int repetitions, int edits) {
        return fullMs(size) * ((WARM_UPS + repetitions) * (1 + 0.2 * edits) + 2 * edits);
    }
}
