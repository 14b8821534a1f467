package lightning.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.text.Quote;

/** A file that reading comes to the end of. */
public final class OrdinaryFile {
    private OrdinaryFile() {}

    /**
     * Refuses what must not even be opened: a pipe would wait for its other end, and some devices never end. What is not there is
     * left to whoever reads it.
     *
     * @param expected as in {@code a .jen file}
     * @throws IOException if it is a folder, a pipe, a socket or a device; the message is a sentence for the user
     */
    public static void check(Path file, String expected) throws IOException {
        if (Files.isDirectory(file)) {
            throw new IOException(Quote.path(file) + ": is a folder, expected " + expected);
        }
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            throw new IOException(Quote.path(file) + ": is no file but a pipe or a device, expected " + expected);
        }
    }
}
