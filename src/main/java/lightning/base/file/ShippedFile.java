package lightning.base.file;

import java.nio.file.Files;
import java.nio.file.Path;

/** Scenes shipped with the program, in its installation folder: the system property {@code lightning.home}. */
public final class ShippedFile {
    /** Folder of the scenes. */
    public static final Path SCENES = Path.of("scenes");

    private ShippedFile() {}

    /**
     * Resolves a file name. If the working directory has no folder {@code scenes}, a name such as {@code scenes/bird.jen} resolves to the
     * shipped scene, so that the help's examples work in any directory.
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
