package lightning.editor.window.command;

import java.io.File;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** Lets a window of the system open elsewhere where the folder that it should open at is gone. */
final class MissingFolderFallback {
    private MissingFolderFallback() {}

    /**
     * What the artist chooses; null where nothing.
     *
     * @param folder sets where the window opens; null is the system's choice
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
