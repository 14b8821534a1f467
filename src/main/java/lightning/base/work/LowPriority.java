package lightning.base.work;

import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.ValueLayout;
import java.lang.invoke.MethodHandle;
import java.util.Optional;

/**
 * Low operating-system priority for a thread. On Linux each thread has its own ({@code nice(2)}), inherited by the threads that it starts,
 * and can lower it but not raise it again. Does nothing on other systems, where the priority applies to whole processes, or if Java may not
 * call native code.
 */
final class LowPriority {
    /** Under full load the thread gets a ninth of a normal thread's processor time (the kernel's weights: 110 of 1024). */
    private static final int NICE_INCREMENT = 10;

    private LowPriority() {}

    /** Lowers the priority of the calling thread. */
    static void apply() {
        try {
            Optional<MethodHandle> nice =
                    NativeFunction.findOnLinux("nice", FunctionDescriptor.of(ValueLayout.JAVA_INT, ValueLayout.JAVA_INT));
            if (nice.isPresent()) {
                // The result, even a failure, does not matter.
                var _ = (int) nice.get().invokeExact(NICE_INCREMENT);
            }
        } catch (Throwable e) {
            // The thread runs with its current priority.
        }
    }
}
