package lightning.base.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import lightning.base.text.Quote;

/** A file that reading comes to the end of. All that a user or a file names is opened here. */
public final class RegularFile {
    private RegularFile() {}

    /**
     * Refuses what must not even be opened: a pipe would wait for its other end, and some devices never end. What is not there is
     * left to whoever reads it.
     *
     * @param expected as in {@code a .jen file}
     * @throws IOException if it is a folder, a pipe, a socket or a device; the message is a sentence for the user
     */
    public static void check(Path file, String expected) throws IOException {
        Optional<String> irregular = describeIrregular(file);
        if (irregular.isPresent()) {
            throw new IOException(Quote.path(file) + ": is " + irregular.get() + ", expected " + expected);
        }
    }

    /** What stands there instead of a file, as in {@code a folder}; empty for a file, and where there is nothing. */
    public static Optional<String> describeIrregular(Path file) {
        return Files.isDirectory(file) ? Optional.of("a folder")
                : Files.exists(file) && !Files.isRegularFile(file) ? Optional.of("a pipe or a device") : Optional.empty();
    }

    /**
     * Opens a file for reading.
     *
     * @throws IOException as {@link #check}, or if it cannot be read
     */
    public static InputStream open(Path file, String expected) throws IOException {
        check(file, expected);
        return Files.newInputStream(file);
    }

    /**
     * All bytes of a file.
     *
     * @param maxBytes how many there may be
     * @throws IOException as {@link #open}, or if there are more; no more than these are read of a file that grows meanwhile
     */
    public static byte[] readBytes(Path file, String expected, int maxBytes) throws IOException {
        try (InputStream in = open(file, expected)) {
            long size = Files.size(file);
            byte[] bytes = size > maxBytes ? null : in.readNBytes(maxBytes);
            if (bytes == null || in.read() >= 0) {
                throw new IOException(
                        Quote.path(file) + ": expected at most " + maxBytes + " bytes, found " + Math.max(size, maxBytes + 1L));
            }
            return bytes;
        }
    }

    /**
     * Whether two files hold the same bytes.
     *
     * @throws IOException as {@link #check} of either, or if one cannot be read
     */
    public static boolean haveSameContent(Path first, Path second, String expected) throws IOException {
        check(first, expected);
        check(second, expected);
        return Files.mismatch(first, second) < 0;
    }
}
