package lightning.bench.result;

/**
 * Time and error of one anti-aliasing setting.
 *
 * @param setting short label, as in {@code edges 4×4}
 * @param time    trace time without loading the scene
 * @param error   difference from the program's image of many samples; see {@link lightning.bench.accuracy.DisplayError}
 */
public record ErrorPoint(String setting, TimeSamples time, double error) {}
