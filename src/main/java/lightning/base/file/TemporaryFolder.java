package lightning.base.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.stream.Stream;

/** Deletion of a temporary folder. */
public final class TemporaryFolder {
    private TemporaryFolder() {}

    /**
     * Deletes a folder with everything in it.
     *
     * @throws IOException if a file cannot be deleted; others may be deleted then
     */
    public static void delete(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(file);
            }
        }
    }
}
