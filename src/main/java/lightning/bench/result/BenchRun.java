package lightning.bench.result;

import java.util.List;

/**
 * Settings and circumstances of a benchmark run.
 *
 * @param date             start, as in {@code 2026-01-31T12:00:00Z}
 * @param commit           measured build: last commit that changed the program, 40 digits, with {@code -dirty} for uncommitted changes of
 *         its sources; {@code unknown} outside of its repository
 * @param load             other work on the machine during the run
 * @param arguments        command arguments
 * @param seed             random seed
 * @param threads          number of threads of each task
 * @param repetitions      number of samples of each task
 * @param quick            whether it measured only a small selection
 * @param predictedSeconds predicted duration, before the start
 * @param actualSeconds    duration
 * @param complete         whether it finished; otherwise these are the results until it was canceled
 * @param triadGBs         memory bandwidth, 10⁹ bytes read and written per second: the best triad
 * @param triadSamples     bandwidth of every triad
 */
public record BenchRun(String date, String commit, List<String> arguments, MachineSpec machine, SystemLoad load, long seed, int threads,
        int repetitions,
        boolean quick, double predictedSeconds, double actualSeconds, boolean complete, double triadGBs, List<Double> triadSamples) {
    public BenchRun {
        arguments = List.copyOf(arguments);
        triadSamples = List.copyOf(triadSamples);
    }

    /** Returns this run with its duration and load so far. */
    public BenchRun withOutcome(double seconds, boolean isComplete, SystemLoad currentLoad) {
        return new BenchRun(date, commit, arguments, machine, currentLoad, seed, threads, repetitions, quick, predictedSeconds, seconds,
                isComplete,
                triadGBs, triadSamples);
    }
}
