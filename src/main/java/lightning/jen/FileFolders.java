package lightning.jen;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import lightning.text.Quote;

/**
 * Where the files that a scene names may be: beside the scene's own file, in a folder of a certain name there, or in the folder of
 * that name in the nearest of the three folders above that has one. No other place is ever looked at.
 */
final class FileFolders {
    private static final int FOLDERS_ABOVE = 3;

    private final Path scene;
    private final String noun;
    private final String name;

    /**
     * @param scene the folder that holds the scene file
     * @param noun  what messages call such a file
     * @param name  the folder's name
     */
    FileFolders(Path scene, String noun, String name) {
        this.scene = scene;
        this.noun = noun;
        this.name = name;
    }

    /**
     * The file of a name that is allowed.
     *
     * @throws UnusableFileException if there is none, or a link leads out of the folders
     * @throws IOException           if the folders cannot be read
     */
    Path find(String file) throws UnusableFileException, IOException {
        FileName.check(noun, file, name);
        List<Path> folders = all();
        for (Path folder : folders) {
            Path path = folder.resolve(file);
            if (Files.isRegularFile(path)) {
                Path real = path.toRealPath();
                if (!real.startsWith(folder)) {
                    throw new UnusableFileException(noun + " " + Quote.of(file) + " must be inside " + shown(folder)
                            + ", found a link that leads out of it");
                }
                return real;
            }
        }
        throw new UnusableFileException("there is no " + noun + " " + Quote.of(file) + " in "
                + String.join(" or ", folders.stream().map(FileFolders::shown).toList()));
    }

    /** The folders, without links on the way; the named one itself may be one, which then leads out. */
    List<Path> all() throws IOException {
        List<Path> folders = new ArrayList<>();
        Path above = scene.toRealPath();
        folders.add(above);
        for (int i = 0; i <= FOLDERS_ABOVE && above != null; i++, above = above.getParent()) {
            Path named = above.resolve(name);
            if (Files.isDirectory(named)) {
                folders.add(named);
                break;
            }
        }
        return folders;
    }

    private static String shown(Path folder) {
        return "the folder " + Quote.of((folder.getFileName() == null ? folder : folder.getFileName()).toString());
    }
}
