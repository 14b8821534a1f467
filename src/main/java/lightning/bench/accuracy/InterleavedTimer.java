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
 * @param maxWarmUpMs   how long it warms up at most, milliseconds of its thread's own work, beyond the least number of rounds: where others
 *                     have the processors, Java comes to compile as late
 * @param steadyMs     for how long, milliseconds of the works' own time, no work may have become faster: works that take next
 *                     to nothing stay as slow as they are for many rounds, until Java comes to compile them
 */
record InterleavedTimer(int repetitions, double maxWarmUpMs, double steadyMs) {
    /** One work; it may prepare something before the time that it tells. */
    @FunctionalInterface
    interface TimedTask<X extends Exception> {
        /** Works once and tells how long that took, milliseconds. */
        double runMs() throws X;
    }

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    private static final double MAX_WARM_UP_MS = 3000;
    private static final int MIN_WARM_UPS = 2;
    private static final int STEADY_ROUNDS = 2;
    /** A new best time counts where it is so much shorter than the last. */
    private static final double FASTER_FACTOR = 0.95;

    InterleavedTimer {
        if (repetitions < 1) {
            throw new IllegalArgumentException("number of repetitions: expected ≥ 1, found " + repetitions);
        }
    }

    /** Two rounds that are no faster are enough: for works that ran for a while before. */
    InterleavedTimer(int repetitions, double maxWarmUpMs) {
        this(repetitions, maxWarmUpMs, 0);
    }

    InterleavedTimer(int repetitions) {
        this(repetitions, MAX_WARM_UP_MS);
    }

    /**
     * Measures works in turns.
     *
     * @param progress hears of finished rounds
     * @return a timing for each work
     * @throws CancellationException if {@code progress} asked to stop
     * @throws X whatever a work throws
     */
    <X extends Exception> List<Timing> warmUpAndMeasure(List<TimedTask<X>> tasks, Progress progress) throws X {
        warmUp(tasks, progress);
        return measure(tasks, progress);
    }

    /** The same without warming up. */
    <X extends Exception> List<Timing> measure(List<TimedTask<X>> tasks, Progress progress) throws X {
        List<List<Double>> samples = new ArrayList<>();
        tasks.forEach(_ -> samples.add(new ArrayList<>()));
        for (int round = 0; round < repetitions; round++) {
            for (int i = 0; i < tasks.size(); i++) {
                samples.get(i).add(runTask(tasks.get(i), progress));
            }
            progress.report(round + 1, repetitions);
        }
        return samples.stream().map(Timing::new).toList();
    }

    /** Works until all works are steady; returns false where patience ended before. */
    <X extends Exception> boolean warmUp(List<TimedTask<X>> tasks, Progress progress) throws X {
        double[] best = new double[tasks.size()];
        Arrays.fill(best, Double.POSITIVE_INFINITY);
        double start = threadCpuMs();
        int steadyRounds = 0;
        double steadyTotalMs = 0;
        for (int round = 0; round < MIN_WARM_UPS || !isSteady(steadyRounds, steadyTotalMs) && threadCpuMs() - start < maxWarmUpMs;
                round++) {
            steadyRounds++;
            for (int i = 0; i < best.length; i++) {
                double ms = runTask(tasks.get(i), progress);
                if (ms < FASTER_FACTOR * best[i]) {
                    steadyRounds = 0;
                    steadyTotalMs = 0;
                }
                steadyTotalMs += ms;
                best[i] = Math.min(best[i], ms);
            }
        }
        return isSteady(steadyRounds, steadyTotalMs);
    }

    private boolean isSteady(int rounds, double milliseconds) {
        return rounds >= STEADY_ROUNDS && milliseconds >= steadyMs;
    }

    private static <X extends Exception> double runTask(TimedTask<X> task, Progress progress) throws X {
        if (progress.isCanceled()) {
            throw new CancellationException("canceled while measuring");
        }
        return task.runMs();
    }

    /** How long a work takes, milliseconds. */
    static double timeMs(Runnable task) {
        long start = System.nanoTime();
        task.run();
        return (System.nanoTime() - start) / 1e6;
    }

    /** How long the calling thread had a processor, milliseconds. */
    private static double threadCpuMs() {
        return THREADS.getCurrentThreadCpuTime() / 1e6;
    }
}
