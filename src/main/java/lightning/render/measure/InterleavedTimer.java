package lightning.render.measure;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;

/**
 * Timer that measures several tasks in turns, so that a temporary slowdown of the machine affects all of them.
 *
 * <p>It warms up first, until no task has become notably faster for two rounds and {@code steadyMs}, or the time limit ends.
 *
 * @param repetitions number of measurements of each task, ≥ 1
 * @param maxWarmUpMs maximum warm-up beyond the minimum number of rounds, in milliseconds of the thread's processor time: on a busy machine
 *         the JIT compiler is delayed too
 * @param steadyMs    minimum steady time, milliseconds of the tasks: very short tasks need many rounds until the JIT compiler compiles them
 */
public record InterleavedTimer(int repetitions, double maxWarmUpMs, double steadyMs) {
    /** Task to measure; untimed preparation is allowed. */
    @FunctionalInterface
    public interface TimedTask<X extends Exception> {
        /** Runs once and returns the time in milliseconds. */
        double runMs() throws X;
    }

    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
    /** Default maximum warm-up, milliseconds. */
    public static final double MAX_WARM_UP_MS = 3000;
    private static final int MIN_WARM_UPS = 2;
    private static final int STEADY_ROUNDS = 2;
    /** Ratio to the previous best time below which a task counts as faster. */
    private static final double FASTER_FACTOR = 0.95;

    public InterleavedTimer {
        if (repetitions < 1) {
            throw new IllegalArgumentException("number of repetitions: expected ≥ 1, found " + repetitions);
        }
    }

    /** Creates a timer that stops warming up after two rounds without improvement, for tasks that ran before. */
    public InterleavedTimer(int repetitions, double maxWarmUpMs) {
        this(repetitions, maxWarmUpMs, 0);
    }

    public InterleavedTimer(int repetitions) {
        this(repetitions, MAX_WARM_UP_MS);
    }

    /**
     * Measures tasks in turns.
     *
     * @param progress receives finished rounds
     * @return timings per task
     * @throws CancellationException if {@code progress} requests a stop
     * @throws X any exception of a task
     */
    public <X extends Exception> List<Timing> warmUpAndMeasure(List<TimedTask<X>> tasks, Progress progress) throws X {
        warmUp(tasks, progress);
        return measure(tasks, progress);
    }

    /** Measures tasks in turns without warm-up. */
    public <X extends Exception> List<Timing> measure(List<TimedTask<X>> tasks, Progress progress) throws X {
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

    /** Runs all tasks until they are steady; returns false if the time limit ended first. */
    public <X extends Exception> boolean warmUp(List<TimedTask<X>> tasks, Progress progress) throws X {
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
        progress.checkCanceled("canceled while measuring");
        return task.runMs();
    }

    /** Returns the time of a task in milliseconds. */
    public static double timeMs(Runnable task) {
        long start = System.nanoTime();
        task.run();
        return (System.nanoTime() - start) / 1e6;
    }

    /** Returns the processor time of the calling thread in milliseconds. */
    private static double threadCpuMs() {
        return THREADS.getCurrentThreadCpuTime() / 1e6;
    }
}
