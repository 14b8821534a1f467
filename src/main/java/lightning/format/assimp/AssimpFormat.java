package lightning.format.assimp;

import java.util.List;
import java.util.Locale;

/** Formats that Assimp reads and this program does not. */
public final class AssimpFormat {
    /** File extensions, in lower case. Assimp has more; these are the formats with meshes that were tried with several files. */
    private static final List<String> EXTENSIONS =
            List.of(".fbx", ".dae", ".3ds", ".stl", ".3mf", ".off", ".lwo", ".ac", ".ase", ".x", ".dxf");

    private AssimpFormat() {}

    /** Returns the file extensions, in lower case. */
    public static List<String> extensions() {
        return EXTENSIONS;
    }

    /** Returns whether a file has one of the extensions. */
    public static boolean isModelName(String file) {
        String name = file.toLowerCase(Locale.ROOT);
        return EXTENSIONS.stream().anyMatch(name::endsWith);
    }
}
