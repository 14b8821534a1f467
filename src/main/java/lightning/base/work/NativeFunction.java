package lightning.base.work;

import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.Linker;
import java.lang.invoke.MethodHandle;
import java.util.Optional;

/** Native functions of the operating system. */
final class NativeFunction {
    private NativeFunction() {}

    /** Looks up a Linux function; empty on other systems, or if Java may not call native code. */
    @SuppressWarnings("restricted")
    static Optional<MethodHandle> findOnLinux(String name, FunctionDescriptor type) {
        if (!System.getProperty("os.name").equals("Linux") || !NativeFunction.class.getModule().isNativeAccessEnabled()) {
            return Optional.empty();
        }
        Linker linker = Linker.nativeLinker();
        return linker.defaultLookup().find(name).map(function -> linker.downcallHandle(function, type));
    }
}
