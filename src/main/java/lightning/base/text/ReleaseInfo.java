package lightning.base.text;

import java.io.IOException;
import java.io.InputStream;
import java.lang.module.InvalidModuleDescriptorException;
import java.lang.module.ModuleDescriptor;
import java.net.URL;
import java.util.Optional;
import java.util.stream.Stream;

/** Which release of the program this is. */
public final class ReleaseInfo {
    private ReleaseInfo() {}

    /** The release, and the Java that it runs on: {@code Lightning 1.0 on Java 25.0.1+8}. */
    public static String text() {
        String number = descriptor().flatMap(ModuleDescriptor::rawVersion).orElse("of a build");
        return "Lightning " + number + " on Java " + Runtime.version();
    }

    /** What machines that go together must agree in: who traces otherwise might see other bits. */
    public static String machineText() {
        return text() + " on " + System.getProperty("os.arch");
    }

    /** The program is a module wherever it lies, but on a class path runs as none: its descriptor is a file of it there. */
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
