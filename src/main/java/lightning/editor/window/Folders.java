package lightning.editor.window;

import java.nio.file.Path;
import lightning.base.file.ShippedFile;

/** Where the editor finds its scenes and keeps what is its own. */
final class Folders {
    private Folders() {}

    /** Preferences and unsaved scenes: the system property {@code lightning.data}, or a folder in the user's home. */
    static Path data() {
        String given = System.getProperty("lightning.data");
        return given != null ? Path.of(given) : Path.of(System.getProperty("user.home"), ".lightning");
    }

    /** What opens when no scene is named. */
    static Path firstScene() {
        return ShippedFile.find(ShippedFile.SCENES.resolve("bird.jen"));
    }
}
