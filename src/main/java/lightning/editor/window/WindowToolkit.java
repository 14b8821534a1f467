package lightning.editor.window;

import java.util.Optional;
import java.util.logging.Logger;
import javafx.application.Platform;

/** Starts the JavaFX toolkit. */
final class WindowToolkit {
    /** Strong reference: a logger without one is collected and loses its filter. */
    private static final Logger LOGGER = Logger.getLogger("javafx");

    private WindowToolkit() {}

    /**
     * Starts the toolkit, at most once per process.
     *
     * @return reason why no window can be opened, in one clause without a full stop; empty on success
     */
    static Optional<String> start() {
        // The launcher starts on the class path, about which JavaFX warns: docs/decisions/0030-class-data-archive.md.
        LOGGER.setFilter(line -> !line.getMessage().startsWith("Unsupported JavaFX configuration"));
        try {
            Platform.startup(() -> {});
            return Optional.empty();
        } catch (RuntimeException | LinkageError e) {
            return Optional.of("cannot open a window (" + e.getMessage()
                    + "; requires a display and, on Debian, the packages libgtk-3-0 and libxtst6)");
        }
    }
}
