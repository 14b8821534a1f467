package lightning.editor.window;

import java.nio.file.Path;
import lightning.base.file.ShippedFile;

/** Where the editor finds its scenes and keeps what is its own. */
final class EditorPaths {
    private EditorPaths() {}

    /** Preferences and unsaved scenes: the system property {@code lightning.data}, or a folder in the user's home. */
    static Path dataFolder() {
        String property = System.getProperty("lightning.data");
        return property != null ? Path.of(property) : Path.of(System.getProperty("user.home"), ".lightning");
    }

    /** What opens when no scene is named. */
    static Path defaultScene() {
        return ShippedFile.resolve(ShippedFile.SCENES.resolve("bird.jen"));
    }
}
