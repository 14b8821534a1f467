package lightning.work;

import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.Linker;
import java.lang.foreign.ValueLayout;
import java.lang.invoke.MethodHandle;

/**
 * Lets the operating system run a thread on what others leave of the processors. On Linux each thread has a rank of its own
 * ({@code nice(2)}; threads that it makes get the same), and may lower it but not raise it again. Other systems give one to whole
 * processes, and nothing happens there, nor where Java may not call native code.
 */
final class LowRank {
    /** Where processors are wanted by all, a ninth of what a thread of usual rank gets (the kernel's weights: 110 of 1024). */
    private static final int STEPS = 10;

    private LowRank() {}

    /** Lowers the rank of the thread that calls. */
    static void take() {
        if (!System.getProperty("os.name").equals("Linux") || !LowRank.class.getModule().isNativeAccessEnabled()) {
            return;
        }
        try {
            Linker linker = Linker.nativeLinker();
            MethodHandle nice = linker.downcallHandle(linker.defaultLookup().find("nice").orElseThrow(),
                    FunctionDescriptor.of(ValueLayout.JAVA_INT, ValueLayout.JAVA_INT));
            // What it answers, a failure too, changes nothing.
            var _ = (int) nice.invokeExact(STEPS);
        } catch (Throwable e) {
            // The thread works with the rank that it has.
        }
    }
}
