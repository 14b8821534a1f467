package lightning.base.work;

import java.lang.foreign.Arena;
import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.ValueLayout;
import java.lang.invoke.MethodHandle;
import java.nio.charset.Charset;
import java.util.List;
import java.util.Optional;

/**
 * Replacement of this process by another program ({@code execv(2)}). The process id, environment, working folder and standard streams stay,
 * so a parent can wait for or end the new program. Works only on Linux and if Java may call native code.
 */
public final class ProcessRestart {
    private ProcessRestart() {}

    /**
     * Runs a program in place of this one; no further code of this program runs, including shutdown hooks. Returns only on failure, without
     * side effects.
     *
     * @param command the program's file and its arguments, without NUL characters
     */
    public static void exec(List<String> command) {
        try (Arena arena = Arena.ofConfined()) {
            Optional<MethodHandle> execv = NativeFunction.findOnLinux("execv",
                    FunctionDescriptor.of(ValueLayout.JAVA_INT, ValueLayout.ADDRESS, ValueLayout.ADDRESS));
            if (execv.isEmpty()) {
                return;
            }
            // The charset with which Java decoded the arguments.
            Charset charset = Charset.forName(System.getProperty("sun.jnu.encoding"));
            MemorySegment arguments = arena.allocate(ValueLayout.ADDRESS, command.size() + 1L);
            for (int i = 0; i < command.size(); i++) {
                arguments.setAtIndex(ValueLayout.ADDRESS, i, arena.allocateFrom(command.get(i), charset));
            }
            arguments.setAtIndex(ValueLayout.ADDRESS, command.size(), MemorySegment.NULL);
            var _ = (int) execv.get().invokeExact(arguments.getAtIndex(ValueLayout.ADDRESS, 0), arguments);
        } catch (Throwable e) {
            // Continue with this program.
        }
    }
}
