package lightning.bench;

import lightning.scene.Scene;
import lightning.shading.Progress;
import lightning.shading.TraditionalTracer;
import lightning.shading.Workers;

/**
 * How fast a scene is traced in full here: what predictions are made of.
 *
 * <p>The factors were fitted to runs on two cores; a prediction is good to about a factor of two.
 *
 * @param msPerPixel milliseconds
 */
record Pace(double msPerPixel) {
    private static final PictureSize SMALL = new PictureSize(160, 120);
    /** It traces until so many traces were not notably faster than the best before: the compiler is done. */
    private static final int STEADY_TRACES = 12;
    private static final double NOTABLY = 0.9;
    /** Warming up takes so many rounds, as a rule. */
    private static final double WARM_UPS = 4;
    /** One round of a ladder in full traces: the trace, and seven re-renders of all kinds. */
    private static final double LADDER_ROUND = 2.2;
    /** Comparing the levels with their oracles, in full traces. */
    private static final double LADDER_CHECK = 8;
    /** Measuring how far a ladder's pictures are off, milliseconds a pixel. */
    private static final double ERRORS = 1.6e-3;

    /**
     * Traces small pictures until they are fast; in cold code that takes a while.
     *
     * @param patienceMs how long at most, milliseconds
     */
    static Pace of(Scene scene, Workers workers, double patienceMs, Progress progress) {
        var tracer = new TraditionalTracer(SMALL.of(scene));
        double best = Double.POSITIVE_INFINITY;
        long start = System.nanoTime();
        int steady = 0;
        do {
            long from = System.nanoTime();
            tracer.trace(workers, progress);
            double ms = (System.nanoTime() - from) / 1e6;
            steady = ms < NOTABLY * best ? 0 : steady + 1;
            best = Math.min(best, ms);
        } while (steady < STEADY_TRACES && (System.nanoTime() - start) / 1e6 < patienceMs);
        return new Pace(best / SMALL.pixels());
    }

    double fullMs(PictureSize size) {
        return msPerPixel * size.pixels();
    }

    double ladderMs(PictureSize size, int repetitions) {
        return fullMs(size) * (LADDER_ROUND * (WARM_UPS + repetitions) + LADDER_CHECK) + ERRORS * size.pixels();
    }

    double firstPassMs(PictureSize size, int repetitions) {
        return fullMs(size) * 2.2 * (WARM_UPS + repetitions);
    }

    /** So many edits and a full trace in turns. */
    double updatesMs(PictureSize size, int repetitions, int edits) {
        return fullMs(size) * ((WARM_UPS + repetitions) * (1 + 0.2 * edits) + 2 * edits);
    }
}
