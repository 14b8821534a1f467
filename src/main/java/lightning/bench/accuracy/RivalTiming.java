package lightning.bench.accuracy;

/**
 * A full trace beside another program's, measured in turns.
 *
 * @param full  milliseconds of our full trace that keeps nothing
 * @param rival milliseconds of the other program's
 */
public record RivalTiming(Timing full, Timing rival) {
    /** How many times as fast ours is. */
    public double ratio() {
        return rival.median() / full.median();
    }
}
