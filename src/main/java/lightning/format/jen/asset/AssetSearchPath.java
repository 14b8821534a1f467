package lightning.format.jen.asset;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import lightning.base.file.FolderEntry;
import lightning.base.file.UnusableFileException;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.format.mesh.MeshException;

/**
 * Search path for the files that a scene references: the scene file's folder, a subfolder with a certain name, or the folder
 * of that name in the nearest of three parent folders. No other folder is searched.
 *
 * @param scene folder of the scene file
 * @param noun  name of such a file in messages
 * @param name  name of the subfolder
 */
public record AssetSearchPath(Path scene, String noun, String name) {
    private static final int MAX_PARENTS = 3;

    /**
     * Returns the file for a valid name; if there is none, the only one of that name in another case.
     *
     * @throws UnusableFileException if it does not exist, or a link leads out of the folders
     * @throws IOException if the folders cannot be read
     */
    public Path find(String file) throws IOException {
        FileName.check(noun, file, name);
        List<Path> folders = folders();
        for (Path folder : folders) {
            Path path = folder.resolve(file);
            if (Files.isRegularFile(path)) {
                return real(file, folder, path);
            }
        }
        for (Path folder : folders) {
            Optional<Path> path = FolderEntry.find(folder, folder.getFileSystem().getPath(file));
            if (path.isPresent() && Files.isRegularFile(path.get())) {
                return real(file, folder, path.get());
            }
        }
        throw new UnusableFileException("there is no " + noun + " " + Quote.of(file) + " in "
                + String.join(" or ", folders.stream().map(AssetSearchPath::describe).toList()));
    }

    private Path real(String file, Path folder, Path path) throws IOException {
        Path real = path.toRealPath();
        if (!real.startsWith(folder)) {
            throw new UnusableFileException(noun + " " + Quote.of(file) + " must be inside " + describe(folder)
                    + ", found a link to another folder");
        }
        return real;
    }

    /** Reads the content of a file. */
    interface AssetReader<T> {
        T read(Path path) throws IOException, MeshException;
    }

    /**
     * Returns the content of the file for a valid name.
     *
     * @throws UnusableFileException if it does not exist, a link leads out of the folders, or it cannot be read; the message
     *     contains the cause
     */
    <T> T read(String file, AssetReader<T> reader) throws UnusableFileException {
        try {
            return reader.read(find(file));
        } catch (UnusableFileException e) {
            throw e;
        } catch (IOException | InvalidPathException | SecurityException e) {
            throw new UnusableFileException(noun + " " + Quote.of(file) + " cannot be read: " + e.getMessage());
        } catch (RefusalException | MeshException e) {
            throw new UnusableFileException(String.valueOf(e.getMessage()));
        }
    }

    /** Returns the folders with resolved parent links; the named folder itself may be a link, which then leads out. */
    public List<Path> folders() throws IOException {
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

    /** Returns the valid names of regular files in all folders that match, in alphabetical order; skips unreadable folders. */
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
