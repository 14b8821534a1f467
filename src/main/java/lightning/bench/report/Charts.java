package lightning.bench.report;

/** What holds for all charts. */
final class Charts {
    private static final double SMALLEST = 1e-15;
    private static final double LARGEST = 1e15;

    private Charts() {}

    /** Whether a value can stand on a logarithmic axis. */
    static boolean plausible(double value) {
        return value > SMALLEST && value < LARGEST;
    }

    /** The same, or exactly 0. */
    static boolean plausibleOrZero(double value) {
        return value == 0 || plausible(value);
    }
}
