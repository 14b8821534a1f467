package lightning.editor.window.command;

import java.io.File;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** Opens a system file dialog at its default folder if the initial folder no longer exists. */
final class MissingFolderFallback {
    private MissingFolderFallback() {}

    /**
     * Returns the chosen file, or null if canceled.
     *
     * @param folder  sets the initial folder; null for the system's choice
     */
    static File show(Consumer<File> folder, Supplier<File> show) {
        try {
            return show.get();
        } catch (IllegalArgumentException e) {
            folder.accept(null);
            return show.get();
        }
    }
}
