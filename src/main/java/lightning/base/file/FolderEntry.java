package lightning.base.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Search for files whose names were written on a system that ignores case. */
public final class FolderEntry {
    private FolderEntry() {}

    /**
     * Returns a file or folder by its path in a folder. A part of the path that does not exist stands for the only entry of its name in another case.
     *
     * @return empty if there is none, or a part stands for several
     * @throws IOException if a folder cannot be read
     * @throws InvalidPathException if the system cannot have such a path
     */
    public static Optional<Path> find(Path folder, Path relative) throws IOException {
        Path at = folder;
        for (Path name : relative) {
            Optional<Path> child = child(at, name.toString());
            if (child.isEmpty()) {
                return Optional.empty();
            }
            at = child.get();
        }
        return Optional.of(at);
    }

    private static Optional<Path> child(Path folder, String name) throws IOException {
        if (Files.exists(folder.resolve(name))) {
            return Optional.of(folder.resolve(name));
        }
        if (!Files.isDirectory(folder)) {
            return Optional.empty();
        }
        try (Stream<Path> entries = Files.list(folder)) {
            List<Path> matches = entries.filter(entry -> entry.getFileName().toString().equalsIgnoreCase(name)).limit(2).toList();
            return matches.size() == 1 ? Optional.of(matches.getFirst()) : Optional.empty();
        }
    }
}
