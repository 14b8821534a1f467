package lightning.base.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/**
 * What a file holds, short enough to remember. Its content decides whether it was changed: a file that is only touched is
 * unchanged, and one that another program wrote within the clock's grain, with the same size, is not.
 *
 * @param modified when it was written last
 * @param size     bytes; −1 where there is no file
 * @param content  its SHA-256 in hexadecimal; empty where it is not known
 */
public record FileState(FileTime modified, long size, String content) {
    /** No file. */
    public static final FileState MISSING = new FileState(FileTime.fromMillis(0), -1, "");

    /** Larger files are compared by time and size alone: reading them at each look would take too long. */
    private static final long MAX_HASHED_BYTES = 64L << 20;

    /**
     * What a file holds now; {@link #MISSING} if there is none.
     *
     * @throws IOException if it cannot be read
     */
    public static FileState of(Path file) throws IOException {
        FileState metadata = readMetadata(file);
        return metadata.size < 0 || metadata.size > MAX_HASHED_BYTES || !Files.isRegularFile(file) ? metadata
                : read(file, metadata.modified);
    }

    /** Time and size alone, which takes no reading. */
    public static FileState readMetadata(Path file) throws IOException {
        if (!Files.exists(file)) {
            return MISSING;
        }
        var attributes = Files.readAttributes(file, BasicFileAttributes.class);
        return new FileState(attributes.lastModifiedTime(), attributes.size(), "");
    }

    FileState withContent(byte[] bytes) {
        return new FileState(modified, size, size > MAX_HASHED_BYTES ? "" : HexFormat.of().formatHex(sha256().digest(bytes)));
    }

    /** Whether time and size are the same. */
    public boolean hasSameMetadata(FileState other) {
        return modified.equals(other.modified) && size == other.size;
    }

    /** Whether both stand for the same content. */
    public boolean hasSameContent(FileState other) {
        return size == other.size
                && (content.isEmpty() || other.content.isEmpty() ? hasSameMetadata(other) : content.equals(other.content));
    }

    /** Whether a file is there that holds anything else. */
    boolean differsFrom(Path file) throws IOException {
        return Files.exists(file) && !hasSameContent(of(file));
    }

    /** The size is that of what was read: another program may write meanwhile. */
    private static FileState read(Path file, FileTime modified) throws IOException {
        MessageDigest digest = sha256();
        byte[] buffer = new byte[1 << 16];
        long size = 0;
        try (InputStream in = Files.newInputStream(file)) {
            for (int n = in.read(buffer); n >= 0 && size < MAX_HASHED_BYTES; n = in.read(buffer)) {
                digest.update(buffer, 0, n);
                size += n;
            }
        }
        return new FileState(modified, size, HexFormat.of().formatHex(digest.digest()));
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new AssertionError("every Java runtime has SHA-256", e);
        }
    }
}
