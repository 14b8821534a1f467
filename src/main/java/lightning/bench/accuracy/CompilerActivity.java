package lightning.bench.accuracy;

import java.lang.management.CompilationMXBean;
import java.lang.management.ManagementFactory;
import java.util.function.DoubleSupplier;

/**
 * Whether Java's compilers rested while something was timed: what they still worked on is not as fast yet as it will be.
 *
 * @param compileMs milliseconds that they have worked until now
 * @param nowMs    milliseconds from any origin
 */
record CompilerActivity(DoubleSupplier compileMs, DoubleSupplier nowMs) {
    /** Above this share of the time that passed they are at work. */
    private static final double BUSY_SHARE = 0.05;
    private static final CompilationMXBean COMPILATION_BEAN = ManagementFactory.getCompilationMXBean();

    /** Those of this Java; they rest where it does not report their time. */
    static CompilerActivity ofVm() {
        return new CompilerActivity(
                () -> COMPILATION_BEAN != null && COMPILATION_BEAN.isCompilationTimeMonitoringSupported()
                        ? COMPILATION_BEAN.getTotalCompilationTime() : 0,
                () -> System.nanoTime() / 1e6);
    }

    /** Watches them from now on. */
    CompilerWatch startWatch() {
        return new CompilerWatch(this, compileMs.getAsDouble(), nowMs.getAsDouble());
    }

    /** What they did since a moment. */
    record CompilerWatch(CompilerActivity compilers, double startCompileMs, double startMs) {
        /** Whether they worked for less than a twentieth of the time. */
        boolean isIdle() {
            return compilers.compileMs.getAsDouble() - startCompileMs < BUSY_SHARE * (compilers.nowMs.getAsDouble() - startMs);
        }
    }
}
