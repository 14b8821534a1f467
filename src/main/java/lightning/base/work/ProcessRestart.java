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
 * Another program in this process's place ({@code execv(2)}): the process's number, its environment, folder and standard streams stay, so
 * whoever waits for this program or ends it does so with the other. Only on Linux, and where Java may call native code.
 */
public final class ProcessRestart {
    private ProcessRestart() {}

    /**
     * Runs a program from its beginning, in place of this one; nothing else of this program runs, no shutdown hook either. Returns only
     * where that cannot be done, and nothing has happened then.
     *
     * @param command the program's file and its arguments, without a NUL
     */
    public static void exec(List<String> command) {
        try (Arena arena = Arena.ofConfined()) {
            Optional<MethodHandle> execv = NativeFunction.findOnLinux("execv",
                    FunctionDescriptor.of(ValueLayout.JAVA_INT, ValueLayout.ADDRESS, ValueLayout.ADDRESS));
            if (execv.isEmpty()) {
                return;
            }
            // As Java decoded them.
            Charset charset = Charset.forName(System.getProperty("sun.jnu.encoding"));
            MemorySegment arguments = arena.allocate(ValueLayout.ADDRESS, command.size() + 1L);
            for (int i = 0; i < command.size(); i++) {
                arguments.setAtIndex(ValueLayout.ADDRESS, i, arena.allocateFrom(command.get(i), charset));
            }
            arguments.setAtIndex(ValueLayout.ADDRESS, command.size(), MemorySegment.NULL);
            var _ = (int) execv.get().invokeExact(arguments.getAtIndex(ValueLayout.ADDRESS, 0), arguments);
        } catch (Throwable e) {
            // This program goes on.
        }
    }
}
