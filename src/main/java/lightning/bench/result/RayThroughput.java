package lightning.bench.result;

import org.jspecify.annotations.Nullable;

/**
 * Throughput of one kind of rays.
 *
 * @param rays  kind of rays
 * @param count number of rays
 * @param time  processor time of tracing all of them on one thread
 * @param rival processor time of another program, measured in turns; null if none is installed
 * @param share our speed in percent of it; NaN without it
 */
public record RayThroughput(String rays, int count, TimeSamples time, @Nullable TimeSamples rival, double share) {
    /** Returns million rays per second. */
    public double millionsPerSecond() {
        return count / time.median() / 1e3;
    }

    /** Returns million rays per second of the other program; NaN without it. */
    public double rivalMillionsPerSecond() {
        return rival == null ? Double.NaN : count / rival.median() / 1e3;
    }
}
