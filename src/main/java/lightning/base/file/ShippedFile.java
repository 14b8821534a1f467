package lightning.base.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** Scenes and images shipped with the program, in its installation folder: the system property {@code lightning.home}. */
public final class ShippedFile {
    /** Folder of the scenes. */
    public static final Path SCENES = Path.of("scenes");

    private ShippedFile() {}

    /**
     * Resolves a file name. If the working directory has no such file, a name such as {@code scenes/bird.jen} resolves to the shipped
     * scene, so that the help's examples work in any directory.
     */
    public static Path resolve(Path name) {
        String home = System.getProperty("lightning.home");
        if (home == null || !name.startsWith(SCENES) || Files.exists(name)) {
            return name;
        }
        Path shipped = Path.of(home).resolve(name);
        return Files.exists(shipped) ? shipped : name;
    }

    /** Returns the installation's folder with images for scenes; empty in a process without an installation. */
    public static Optional<Path> textures() {
        return Optional.ofNullable(System.getProperty("lightning.home")).map(home -> Path.of(home).resolve("textures"));
    }

    /** Returns whether a file is in the scene folder of the installation. Such files are never overwritten. */
    public static boolean isShipped(Path file) {
        String home = System.getProperty("lightning.home");
        return home != null && normalized(file).startsWith(normalized(Path.of(home).resolve(SCENES)));
    }

    /** Returns the absolute path; links are resolved in the part that exists. */
    private static Path normalized(Path path) {
        Path absolute = path.toAbsolutePath().normalize();
        try {
            return absolute.toRealPath();
        } catch (IOException e) {
            Path parent = absolute.getParent();
            return parent == null ? absolute : normalized(parent).resolve(absolute.getFileName());
        }
    }
}
