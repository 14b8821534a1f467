package lightning.bench.accuracy;

import lightning.render.measure.Timing;

/**
 * Timing of a full trace and another program, measured in turns.
 *
 * @param full  milliseconds of our full trace without a cache
 * @param rival milliseconds of the other program
 */
public record RivalTiming(Timing full, Timing rival) {
    /** Returns the speedup of our trace. */
    public double ratio() {
        return rival.median() / full.median();
    }
}
