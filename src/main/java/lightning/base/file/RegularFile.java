package lightning.base.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import lightning.base.text.Quote;

/** Reader for regular files. All files that a user or another file names are opened here. */
public final class RegularFile {
    private RegularFile() {}

    /**
     * Rejects files that must not be opened: a pipe would block, and some devices never end. Missing files are left to the reader.
     *
     * @param expected a noun phrase such as {@code a .jen file}
     * @throws IOException if it is a folder, a pipe, a socket or a device; the message is a sentence for the user
     */
    public static void check(Path file, String expected) throws IOException {
        Optional<String> irregular = describeIrregular(file);
        if (irregular.isPresent()) {
            throw new IOException(Quote.path(file) + ": is " + irregular.get() + ", expected " + expected);
        }
    }

    /** Returns the kind of an irregular file, such as {@code a folder}; empty for a regular or missing file. */
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
     * Reads all bytes of a file.
     *
     * @param maxBytes maximum size
     * @throws IOException as {@link #open}, or if the file is larger; of a growing file, reads at most this size
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
     * Returns whether two files hold the same bytes.
     *
     * @throws IOException as {@link #check} of either, or if one cannot be read
     */
    public static boolean haveSameContent(Path first, Path second, String expected) throws IOException {
        check(first, expected);
        check(second, expected);
        return Files.mismatch(first, second) < 0;
    }
}
