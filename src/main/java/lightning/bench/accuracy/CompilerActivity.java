package lightning.bench.accuracy;

import java.lang.management.CompilationMXBean;
import java.lang.management.ManagementFactory;
import java.util.function.DoubleSupplier;
import org.jspecify.annotations.Nullable;

/**
 * Activity of the JIT compilers during a measurement. Times of code that is still being compiled are too long.
 *
 * @param compileMs supplies the compilers' total milliseconds so far
 * @param nowMs     supplies the current time, milliseconds from any origin
 */
record CompilerActivity(DoubleSupplier compileMs, DoubleSupplier nowMs) {
    /** Share of elapsed time above which the compilers are busy. */
    private static final double BUSY_SHARE = 0.05;
    private static final @Nullable CompilationMXBean COMPILATION_BEAN = ManagementFactory.getCompilationMXBean();

    /** Returns the activity of this Java VM; idle if it does not report compile times. */
    static CompilerActivity ofVm() {
        return new CompilerActivity(
                () -> COMPILATION_BEAN != null && COMPILATION_BEAN.isCompilationTimeMonitoringSupported()
                        ? COMPILATION_BEAN.getTotalCompilationTime() : 0,
                () -> System.nanoTime() / 1e6);
    }

    /** Starts watching the compilers. */
    CompilerWatch startWatch() {
        return new CompilerWatch(this, compileMs.getAsDouble(), nowMs.getAsDouble());
    }

    /** Activity since a start time. */
    record CompilerWatch(CompilerActivity compilers, double startCompileMs, double startMs) {
        /** Returns whether they worked for less than a twentieth of the time. */
        boolean isIdle() {
            return compilers.compileMs.getAsDouble() - startCompileMs < BUSY_SHARE * (compilers.nowMs.getAsDouble() - startMs);
        }
    }
}
