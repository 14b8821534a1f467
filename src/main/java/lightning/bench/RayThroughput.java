package lightning.bench;

/**
 * How fast rays of one kind are traced.
 *
 * @param rays  the kind
 * @param count how many there are
 * @param time  processor time of tracing all of them on one thread
 * @param rival the same of another program, measured in turns; null where none is installed
 * @param share how fast we are in percent of it; NaN where it is not there
 */
public record RayThroughput(String rays, int count, TimeSamples time, TimeSamples rival, double share) {
    /** Million rays a second. */
    public double millionsPerSecond() {
        return count / time.median() / 1e3;
    }

    /** The same of the other program; NaN where it is not there. */
    public double rivalMillionsPerSecond() {
        return rival == null ? Double.NaN : count / rival.median() / 1e3;
    }
}
