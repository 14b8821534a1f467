package lightning.format.jen;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import lightning.base.text.Quote;
import lightning.format.mesh.MeshException;

/**
 * Where the files that a scene names may be: beside the scene's own file, in a folder of a certain name there, or in the folder of
 * that name in the nearest of the three folders above that has one. No other place is ever looked at.
 */
final class AssetSearchPath {
    private static final int MAX_PARENTS = 3;

    private final Path scene;
    private final String noun;
    private final String name;

    /**
     * @param scene the folder that holds the scene file
     * @param noun  what messages call such a file
     * @param name  the folder's name
     */
    AssetSearchPath(Path scene, String noun, String name) {
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
        List<Path> folders = folders();
        for (Path folder : folders) {
            Path path = folder.resolve(file);
            if (Files.isRegularFile(path)) {
                Path real = path.toRealPath();
                if (!real.startsWith(folder)) {
                    throw new UnusableFileException(noun + " " + Quote.of(file) + " must be inside " + describe(folder)
                            + ", found a link that leads out of it");
                }
                return real;
            }
        }
        throw new UnusableFileException("there is no " + noun + " " + Quote.of(file) + " in "
                + String.join(" or ", folders.stream().map(AssetSearchPath::describe).toList()));
    }

    /** What is read from a file. */
    interface AssetReader<T> {
        T read(Path path) throws IOException, UnusableFileException, MeshException;
    }

    /**
     * What a file of a name that is allowed holds.
     *
     * @throws UnusableFileException if there is none, if a link leads out of the folders, or if it cannot be read; the message says why
     */
    <T> T read(String file, AssetReader<T> reader) throws UnusableFileException {
        try {
            return reader.read(find(file));
        } catch (IOException | InvalidPathException | SecurityException e) {
            throw new UnusableFileException(noun + " " + Quote.of(file) + " cannot be read: " + e.getMessage());
        } catch (IllegalArgumentException | MeshException e) {
            throw new UnusableFileException(e.getMessage());
        }
    }

    /** The folders, without links on the way; the named one itself may be one, which then leads out. */
    List<Path> folders() throws IOException {
        List<Path> folders = new ArrayList<>();
        Path folder = scene.toRealPath();
        folders.add(folder);
        for (int i = 0; i <= MAX_PARENTS && folder != null; i++, folder = folder.getParent()) {
            Path subfolder = folder.resolve(name);
            if (Files.isDirectory(subfolder)) {
                folders.add(subfolder);
                break;
            }
        }
        return folders;
    }

    /** The plain files of all folders whose names match and may be written, in alphabetical order; none of unreadable folders. */
    List<String> fileNames(Pattern pattern) {
        var names = new TreeSet<String>(String.CASE_INSENSITIVE_ORDER);
        try {
            for (Path folder : folders()) {
                try (Stream<Path> files = Files.list(folder)) {
                    files.filter(Files::isRegularFile).map(f -> f.getFileName().toString())
                            .filter(f -> pattern.matcher(f).matches()).filter(FileName::isAllowed).forEach(names::add);
                }
            }
        } catch (IOException | UncheckedIOException | SecurityException e) {
            return List.copyOf(names);
        }
        return List.copyOf(names);
    }

    private static String describe(Path folder) {
        return "the folder " + Quote.of((folder.getFileName() == null ? folder : folder.getFileName()).toString());
    }
}
