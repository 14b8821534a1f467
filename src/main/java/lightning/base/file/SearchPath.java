package lightning.base.file;

import java.io.File;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Folders in which the system searches programs.
 *
 * @param folders in the order of the search
 */
public record SearchPath(List<String> folders) {
    /** Returns the value of the environment variable {@code PATH}; without folders if it is not set. */
    public static SearchPath ofSystem() {
        return of(System.getenv("PATH"));
    }

    /** @param value folders, separated as in {@code PATH}; null for none. Empty entries are skipped: the current folder is not searched */
    public static SearchPath of(@Nullable String value) {
        return new SearchPath(value == null ? List.of() : Stream.of(value.split(File.pathSeparator)).filter(f -> !f.isEmpty()).toList());
    }

    /** Returns the first program of a name, with or without {@code .exe}. */
    public Optional<Path> find(String name) {
        return folders.stream().flatMap(folder -> Stream.of(name, name + ".exe").flatMap(file -> program(folder, file).stream()))
                .findFirst();
    }

    /** Returns the file in a folder if it can be executed; empty also for a name that the system does not allow. */
    public static Optional<Path> program(String folder, String name) {
        try {
            return Optional.of(Path.of(folder, name)).filter(file -> Files.isRegularFile(file) && Files.isExecutable(file));
        } catch (InvalidPathException e) {
            return Optional.empty();
        }
    }
}
