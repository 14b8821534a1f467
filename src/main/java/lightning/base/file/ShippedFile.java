package lightning.base.file;

import java.nio.file.Files;
import java.nio.file.Path;

/** The scenes that come with the program, in the folder where it is installed: the system property {@code lightning.home}. */
public final class ShippedFile {
    /** Their folder. */
    public static final Path SCENES = Path.of("scenes");

    private ShippedFile() {}

    /**
     * Returns the file that a name means. Where the working directory has no folder {@code scenes}, a name as
     * {@code scenes/bird.jen} is that of a shipped scene, so that what the help shows works from any directory.
     */
    public static Path resolve(Path name) {
        String home = System.getProperty("lightning.home");
        if (home == null || !name.startsWith(SCENES) || Files.isDirectory(SCENES)) {
            return name;
        }
        Path shipped = Path.of(home).resolve(name);
        return Files.exists(shipped) ? shipped : name;
    }
}
