package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.foreign.Arena;
import java.lang.foreign.SymbolLookup;
import java.util.Map;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import lightning.base.work.Wait;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.testfx.api.FxToolkit;

/**
 * Skips the tests of a class where the machine lacks libraries that JavaFX draws text with, and names
 * the packages; with the environment variable {@value #DEMAND} set, the tests fail instead.
 */
public final class JavaFxNeeds implements BeforeAllCallback {
    private static final String DEMAND = "LIGHTNING_NEEDS_JAVAFX";
    private static final Map<String, String> DEBIAN =
            Map.of("libfreetype.so.6", "libfreetype6", "libpangoft2-1.0.so.0", "libpangoft2-1.0-0");

    @Override
    public void beforeAll(ExtensionContext context) {
        // The first window of a process takes its time on a machine that has other work.
        FxToolkit.toolkitContext().setLaunchTimeoutInMillis(TimeUnit.SECONDS.toMillis(Wait.MOST_SECONDS));
        FxToolkit.toolkitContext().setSetupTimeoutInMillis(TimeUnit.SECONDS.toMillis(Wait.MOST_SECONDS));
        if (!System.getProperty("os.name").equals("Linux")) {
            return;
        }
        var missing = new TreeSet<String>();
        DEBIAN.forEach((library, pack) -> {
            if (!isThere(library)) {
                missing.add(pack);
            }
        });
        String sentence = "JavaFX needs the packages " + String.join(" ", missing);
        if (System.getenv(DEMAND) != null) {
            assertThat(missing).as(sentence).isEmpty();
        }
        Assumptions.assumeTrue(missing.isEmpty(), sentence);
    }

    private static boolean isThere(String library) {
        try (Arena arena = Arena.ofConfined()) {
            SymbolLookup.libraryLookup(library, arena);
            return true;
        } catch (IllegalArgumentException e) {
            return false;
        }
    }
}
