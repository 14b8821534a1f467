package lightning.app;

import java.util.Optional;
import javafx.application.Platform;

/** Where windows open. */
public final class Display {
    private Display() {}

    /**
     * Starts the window toolkit, at most once in a process.
     *
     * @return why no window can be opened, in one clause without a full stop; empty if one can
     */
    public static Optional<String> obstacle() {
        try {
            Platform.startup(() -> {});
            return Optional.empty();
        } catch (RuntimeException | LinkageError e) {
            return Optional.of("no window can be opened here (" + e.getMessage()
                    + "; it takes a display and, on Debian, the packages libgtk-3-0 and libxtst6)");
        }
    }
}
