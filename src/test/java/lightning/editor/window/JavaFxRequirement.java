package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.foreign.Arena;
import java.lang.foreign.SymbolLookup;
import java.util.Map;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import lightning.base.work.Await;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.testfx.api.FxToolkit;

/**
 * Skips a test class if the libraries with which JavaFX draws text are missing, and names the packages. If the environment variable {@value
 * #REQUIRED_VARIABLE} is set, the tests fail instead.
 */
public final class JavaFxRequirement implements BeforeAllCallback {
    private static final String REQUIRED_VARIABLE = "LIGHTNING_NEEDS_JAVAFX";
    private static final Map<String, String> DEBIAN =
            Map.of("libfreetype.so.6", "libfreetype6", "libpangoft2-1.0.so.0", "libpangoft2-1.0-0");

    @Override
    public void beforeAll(ExtensionContext context) {
        // On a busy machine the first window of a process can take long.
        FxToolkit.toolkitContext().setLaunchTimeoutInMillis(TimeUnit.SECONDS.toMillis(Await.TIMEOUT_SECONDS));
        FxToolkit.toolkitContext().setSetupTimeoutInMillis(TimeUnit.SECONDS.toMillis(Await.TIMEOUT_SECONDS));
        if (!System.getProperty("os.name").equals("Linux")) {
            return;
        }
        var missing = new TreeSet<String>();
        DEBIAN.forEach((library, pack) -> {
            if (!isInstalled(library)) {
                missing.add(pack);
            }
        });
        String sentence = "JavaFX needs the packages " + String.join(" ", missing);
        if (System.getenv(REQUIRED_VARIABLE) != null) {
            assertThat(missing).as(sentence).isEmpty();
        }
        Assumptions.assumeTrue(missing.isEmpty(), sentence);
    }

    private static boolean isInstalled(String library) {
        try (Arena arena = Arena.ofConfined()) {
            SymbolLookup.libraryLookup(library, arena);
            return true;
        } catch (IllegalArgumentException e) {
            return false;
        }
    }
}
