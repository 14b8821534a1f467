package lightning.base.work;

import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.ValueLayout;
import java.lang.invoke.MethodHandle;
import java.util.Optional;

/**
 * Lets the operating system run a thread on what others leave of the processors. On Linux each thread has a rank of its own
 * ({@code nice(2)}; threads that it makes get the same), and may lower it but not raise it again. Other systems give one to whole
 * processes, and nothing happens there, nor where Java may not call native code.
 */
final class LowPriority {
    /** Where processors are wanted by all, a ninth of what a thread of usual rank gets (the kernel's weights: 110 of 1024). */
    private static final int NICE_INCREMENT = 10;

    private LowPriority() {}

    /** Lowers the rank of the thread that calls. */
    static void apply() {
        try {
            Optional<MethodHandle> nice =
                    NativeFunction.findOnLinux("nice", FunctionDescriptor.of(ValueLayout.JAVA_INT, ValueLayout.JAVA_INT));
            if (nice.isPresent()) {
                // What it answers, a failure too, changes nothing.
                var _ = (int) nice.get().invokeExact(NICE_INCREMENT);
            }
        } catch (Throwable e) {
            // The thread works with the rank that it has.
        }
    }
}
