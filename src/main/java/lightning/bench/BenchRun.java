package lightning.bench;

import java.util.List;

/**
 * How a run was made.
 *
 * @param date             when it began, as in {@code 2026-01-31T12:00:00Z}
 * @param commit           the build that was measured: the last commit that changed the program, 40 digits, with {@code -dirty} where
 *                         its sources have changes that are not committed; {@code unknown} outside of its repository
 * @param load             other work on the machine during the run
 * @param arguments        the command's arguments
 * @param seed             what everything random starts from
 * @param threads          how many threads each work had
 * @param repetitions      how many samples each work has
 * @param quick            whether it measured only a small selection
 * @param predictedSeconds how long it was going to take, told before it began
 * @param actualSeconds    how long it has taken
 * @param complete         whether it came to its end; else these are the results until it was canceled
 * @param triadGBs         memory bandwidth, 10⁹ bytes read and written in a second: the best triad
 * @param triadSamples     the same of every triad
 */
public record BenchRun(String date, String commit, List<String> arguments, MachineSpec machine, SystemLoad load, long seed, int threads,
        int repetitions,
        boolean quick, double predictedSeconds, double actualSeconds, boolean complete, double triadGBs, List<Double> triadSamples) {
    public BenchRun {
        arguments = List.copyOf(arguments);
        triadSamples = List.copyOf(triadSamples);
    }

    /** The same run after so many seconds, with the load until then. */
    BenchRun withOutcome(double seconds, boolean isComplete, SystemLoad currentLoad) {
        return new BenchRun(date, commit, arguments, machine, currentLoad, seed, threads, repetitions, quick, predictedSeconds, seconds,
                isComplete,
                triadGBs, triadSamples);
    }
}
