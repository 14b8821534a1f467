package lightning.bench.accuracy;

import java.lang.management.CompilationMXBean;
import java.lang.management.ManagementFactory;
import java.util.function.DoubleSupplier;

/**
 * Whether Java's compilers rested while something was timed: what they still worked on is not as fast yet as it will be.
 *
 * @param workedMs milliseconds that they have worked until now
 * @param nowMs    milliseconds from any origin
 */
record Compilers(DoubleSupplier workedMs, DoubleSupplier nowMs) {
    /** Above this share of the time that passed they are at work. */
    private static final double SHARE = 0.05;
    private static final CompilationMXBean OF_JAVA = ManagementFactory.getCompilationMXBean();

    /** Those of this Java; they rest where it does not report their time. */
    static Compilers ofJava() {
        return new Compilers(
                () -> OF_JAVA != null && OF_JAVA.isCompilationTimeMonitoringSupported() ? OF_JAVA.getTotalCompilationTime() : 0,
                () -> System.nanoTime() / 1e6);
    }

    /** Watches them from now on. */
    Watch watch() {
        return new Watch(this, workedMs.getAsDouble(), nowMs.getAsDouble());
    }

    /** What they did since a moment. */
    record Watch(Compilers compilers, double workedMs, double startMs) {
        /** Whether they worked for less than a twentieth of the time. */
        boolean isResting() {
            return compilers.workedMs.getAsDouble() - workedMs < SHARE * (compilers.nowMs.getAsDouble() - startMs);
        }
    }
}
