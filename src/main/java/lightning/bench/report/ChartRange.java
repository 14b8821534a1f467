package lightning.bench.report;

/** Validation of values for all charts. */
final class ChartRange {
    private static final double SMALLEST = 1e-15;
    private static final double LARGEST = 1e15;

    private ChartRange() {}

    /** Returns whether a value fits on a logarithmic axis. */
    static boolean isPlausible(double value) {
        return value > SMALLEST && value < LARGEST;
    }

    /** Returns whether a value fits on a logarithmic axis or is exactly 0. */
    static boolean isPlausibleOrZero(double value) {
        return value == 0 || isPlausible(value);
    }
}
