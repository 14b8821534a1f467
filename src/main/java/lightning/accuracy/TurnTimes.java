package lightning.accuracy;

/**
 * A full trace beside another program's, measured in turns.
 *
 * @param fullMs  milliseconds of our full trace that keeps nothing, median
 * @param rivalMs milliseconds of the other program's, median
 */
public record TurnTimes(double fullMs, double rivalMs) {
    /** How many times as fast ours is. */
    public double ratio() {
        return rivalMs / fullMs;
    }
}
