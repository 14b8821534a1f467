package lightning.sample;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.platform.engine.discovery.ClassSelector;
import org.junit.platform.launcher.LauncherDiscoveryListener;
import org.junit.platform.launcher.LauncherDiscoveryRequest;

/**
 * Gives each test class its own database of jqwik, in the folder of the system property {@code lightning.properties}.
 *
 * <p>A failed property starts with the same values when its class runs again. jqwik replaces a database for each class, so a common one
 * would lose these values with the next class, and two processes would damage each other's file.
 */
public final class PropertyDatabases implements LauncherDiscoveryListener {
    @Override
    public void launcherDiscoveryStarted(LauncherDiscoveryRequest request) {
        String folder = System.getProperty("lightning.properties");
        if (folder != null) {
            request.getSelectorsByType(ClassSelector.class).stream().map(ClassSelector::getClassName).findFirst()
                    .ifPresent(name -> use(Path.of(folder), name));
        }
    }

    private static void use(Path folder, String className) {
        try {
            Files.createDirectories(folder);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        System.setProperty("jqwik.database", folder.resolve(className).toString());
    }
}
