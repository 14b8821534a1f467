package lightning.base.work;

import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.Linker;
import java.lang.invoke.MethodHandle;
import java.util.Optional;

/** Functions of the operating system that Java has no name for. */
final class NativeFunction {
    private NativeFunction() {}

    /** A function of Linux; none on other systems, nor where Java may not call native code. */
    static Optional<MethodHandle> findOnLinux(String name, FunctionDescriptor type) {
        if (!System.getProperty("os.name").equals("Linux") || !NativeFunction.class.getModule().isNativeAccessEnabled()) {
            return Optional.empty();
        }
        Linker linker = Linker.nativeLinker();
        return linker.defaultLookup().find(name).map(function -> linker.downcallHandle(function, type));
    }
}
