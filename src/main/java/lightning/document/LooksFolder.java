package lightning.document;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import lightning.format.jen.JenFile;

/** Place of a scene's looks: the folder {@code NAME.cues} next to {@code NAME.jen}. */
public final class LooksFolder {
    /** Ends the name of a look's lights. */
    public static final String LIGHTS_EXTENSION = JenFile.EXTENSION;
    /** Ends the name of a look's image. */
    public static final String PICTURE_EXTENSION = ".png";

    private LooksFolder() {}

    /** Returns the folder of a scene file; it may not exist. */
    public static Path of(Path scene) {
        return scene.toAbsolutePath().resolveSibling(JenFile.stem(scene.getFileName().toString()) + ".cues");
    }

    /**
     * Moves the looks of a scene without a file to its new file, after it was saved. A look whose name is in use there gets a number.
     *
     * @param from private folder; nothing happens if it does not exist
     * @throws IOException if a file cannot be moved; it is then still in the old folder
     */
    public static void move(Path from, Path scene) throws IOException {
        if (!Files.exists(from)) {
            return;
        }
        Path to = Files.createDirectories(of(scene));
        List<Path> files;
        try (Stream<Path> all = Files.list(from)) {
            files = all.filter(file -> file.getFileName().toString().endsWith(LIGHTS_EXTENSION)).sorted().toList();
        }
        for (Path lights : files) {
            String name = JenFile.stem(lights.getFileName().toString());
            String free = name;
            for (int i = 2; isUsed(to, free); i++) {
                free = name + " " + i;
            }
            if (Files.exists(from.resolve(name + PICTURE_EXTENSION))) {
                Files.move(from.resolve(name + PICTURE_EXTENSION), to.resolve(free + PICTURE_EXTENSION));
            }
            Files.move(lights, to.resolve(free + LIGHTS_EXTENSION));
        }
    }

    private static boolean isUsed(Path folder, String name) {
        return Files.exists(folder.resolve(name + LIGHTS_EXTENSION)) || Files.exists(folder.resolve(name + PICTURE_EXTENSION));
    }
}
