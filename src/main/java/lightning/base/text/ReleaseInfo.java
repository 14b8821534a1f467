package lightning.base.text;

import java.io.IOException;
import java.io.InputStream;
import java.lang.module.InvalidModuleDescriptorException;
import java.lang.module.ModuleDescriptor;
import java.net.URL;
import java.util.Optional;
import java.util.stream.Stream;

/** Release of the program. */
public final class ReleaseInfo {
    private ReleaseInfo() {}

    /** Returns the release and its Java version: {@code Lightning 1.0 on Java 25.0.1+8}. */
    public static String text() {
        return "Lightning " + number() + " on Java " + Runtime.version();
    }

    /** Returns the number of the release, or {@code of a build} if the program runs from its classes. */
    public static String number() {
        return descriptor().flatMap(ModuleDescriptor::rawVersion).orElse("of a build");
    }

    /** Returns the release and platform in which all machines of a cluster must agree, because another one might render other bits. */
    public static String machineText() {
        return text() + " on " + System.getProperty("os.arch");
    }

    /** Reads the descriptor from the module, or as a file if the program runs on the class path. */
    private static Optional<ModuleDescriptor> descriptor() {
        Module module = ReleaseInfo.class.getModule();
        if (module.isNamed()) {
            return Optional.of(module.getDescriptor());
        }
        return ReleaseInfo.class.getClassLoader().resources("module-info.class").flatMap(ReleaseInfo::read)
                .filter(descriptor -> descriptor.name().equals("lightning")).findFirst();
    }

    private static Stream<ModuleDescriptor> read(URL file) {
        try (InputStream in = file.openStream()) {
            return Stream.of(ModuleDescriptor.read(in));
        } catch (IOException | InvalidModuleDescriptorException e) {
            return Stream.empty();
        }
    }
}
