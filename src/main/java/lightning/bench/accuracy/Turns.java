package lightning.bench.accuracy;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;

/**
 * Measures several works in turns, one after the other and again, so that whatever slows the machine for a while slows
 * all of them.
 *
 * <p>Before that it warms up until it is steady: until no work has become notably faster for two rounds and for a while, or
 * patience ends.
 *
 * @param repetitions  how often each work is measured, ≥ 1
 * @param patienceMs   how long it warms up at most, milliseconds of its thread's own work, beyond the least number of rounds: where others
 *                     have the processors, Java comes to compile as late
 * @param steadyMs     for how long, milliseconds of the works' own time, no work may have become faster: works that take next
 *                     to nothing stay as slow as they are for many rounds, until Java comes to compile them
 */
record Turns(int repetitions, double patienceMs, double steadyMs) {
    /** One work; it may prepare something before the time that it tells. */
    @FunctionalInterface
    interface Turn<X extends Exception> {
        /** Works once and tells how long that took, milliseconds. */
        double milliseconds() throws X;
    }

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final double PATIENCE_MS = 3000;
    private static final int LEAST_WARM_UPS = 2;
    private static final int STEADY_ROUNDS = 2;
    /** A new best time counts where it is so much shorter than the last. */
    private static final double NOTABLY = 0.95;

    Turns {
        if (repetitions < 1) {
            throw new IllegalArgumentException("the number of repetitions must be ≥ 1, was " + repetitions);
        }
    }

    /** Two rounds that are no faster are enough: for works that ran for a while before. */
    Turns(int repetitions, double patienceMs) {
        this(repetitions, patienceMs, 0);
    }

    Turns(int repetitions) {
        this(repetitions, PATIENCE_MS);
    }

    /**
     * Measures works in turns.
     *
     * @param progress hears of finished rounds
     * @return a timing for each work
     * @throws CancellationException if {@code progress} asked to stop
     * @throws X whatever a work throws
     */
    <X extends Exception> List<Timing> take(List<Turn<X>> works, Progress progress) throws X {
        warmUp(works, progress);
        return measure(works, progress);
    }

    /** The same without warming up. */
    <X extends Exception> List<Timing> measure(List<Turn<X>> works, Progress progress) throws X {
        List<List<Double>> samples = new ArrayList<>();
        works.forEach(_ -> samples.add(new ArrayList<>()));
        for (int round = 0; round < repetitions; round++) {
            for (int i = 0; i < works.size(); i++) {
                samples.get(i).add(next(works.get(i), progress));
            }
            progress.tiles(round + 1, repetitions);
        }
        return samples.stream().map(Timing::new).toList();
    }

    /** Works until all works are steady; returns false where patience ended before. */
    <X extends Exception> boolean warmUp(List<Turn<X>> works, Progress progress) throws X {
        double[] best = new double[works.size()];
        Arrays.fill(best, Double.POSITIVE_INFINITY);
        double start = worked();
        int steady = 0;
        double steadyFor = 0;
        for (int round = 0; round < LEAST_WARM_UPS || !isSteady(steady, steadyFor) && worked() - start < patienceMs; round++) {
            steady++;
            for (int i = 0; i < best.length; i++) {
                double ms = next(works.get(i), progress);
                if (ms < NOTABLY * best[i]) {
                    steady = 0;
                    steadyFor = 0;
                }
                steadyFor += ms;
                best[i] = Math.min(best[i], ms);
            }
        }
        return isSteady(steady, steadyFor);
    }

    private boolean isSteady(int rounds, double milliseconds) {
        return rounds >= STEADY_ROUNDS && milliseconds >= steadyMs;
    }

    private static <X extends Exception> double next(Turn<X> work, Progress progress) throws X {
        if (progress.isCancelled()) {
            throw new CancellationException("cancelled while measuring");
        }
        return work.milliseconds();
    }

    /** How long a work takes, milliseconds. */
    static double time(Runnable work) {
        long start = System.nanoTime();
        work.run();
        return (System.nanoTime() - start) / 1e6;
    }

    /** How long the calling thread had a processor, milliseconds. */
    private static double worked() {
        return THREADS.getCurrentThreadCpuTime() / 1e6;
    }
}
