package lightning.bench.report;

/** What holds for all charts. */
final class ChartRange {
    private static final double SMALLEST = 1e-15;
    private static final double LARGEST = 1e15;

    private ChartRange() {}

    /** Whether a value can stand on a logarithmic axis. */
    static boolean isPlausible(double value) {
        return value > SMALLEST && value < LARGEST;
    }

    /** The same, or exactly 0. */
    static boolean isPlausibleOrZero(double value) {
        return value == 0 || isPlausible(value);
    }
}
