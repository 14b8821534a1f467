package lightning.app;

import java.nio.file.Files;
import java.nio.file.Path;

/** Where the editor finds its scenes and keeps what is its own. */
final class Folders {
    private Folders() {}

    /** Preferences and unsaved scenes: the system property {@code lightning.data}, or a folder in the user's home. */
    static Path data() {
        String given = System.getProperty("lightning.data");
        return given != null ? Path.of(given) : Path.of(System.getProperty("user.home"), ".lightning");
    }

    /** The scenes that come with the program: of the working directory, or of the folder where it is installed. */
    static Path scenes() {
        Path here = Path.of("scenes");
        String home = System.getProperty("lightning.home");
        return Files.isDirectory(here) || home == null ? here : Path.of(home, "scenes");
    }

    /** What opens when no scene is named. */
    static Path firstScene() {
        return scenes().resolve("bird.jen");
    }
}
