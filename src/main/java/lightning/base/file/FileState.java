package lightning.base.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Instant;
import java.time.format.DateTimeParseException;
import java.util.HexFormat;
import java.util.Optional;

/**
 * Fingerprint of a file's content. A file whose time alone changed is unchanged; a file rewritten within the clock's resolution with the
 * same size is changed.
 *
 * @param modified last modification
 * @param size     bytes; −1 for a missing file
 * @param content  SHA-256 in hexadecimal; empty if not computed
 */
public record FileState(FileTime modified, long size, String content) {
    /** State of a missing file. */
    public static final FileState MISSING = new FileState(FileTime.fromMillis(0), -1, "");

    /** Larger files are compared by time and size only, because hashing would take too long. */
    private static final long MAX_HASHED_BYTES = 64L << 20;
    private static final int PARTS = 3;

    /**
     * Returns the current state of a file; {@link #MISSING} if it does not exist.
     *
     * @throws IOException if it cannot be read
     */
    public static FileState of(Path file) throws IOException {
        FileState metadata = readMetadata(file);
        return metadata.size < 0 || metadata.size > MAX_HASHED_BYTES || !Files.isRegularFile(file) ? metadata
                : read(file, metadata.modified);
    }

    /** Reads time and size only, not the content. */
    public static FileState readMetadata(Path file) throws IOException {
        if (!Files.exists(file)) {
            return MISSING;
        }
        var attributes = Files.readAttributes(file, BasicFileAttributes.class);
        return new FileState(attributes.lastModifiedTime(), attributes.size(), "");
    }

    /** Parses the output of {@link #toText}; empty for any other text. */
    public static Optional<FileState> parse(String text) {
        String[] parts = text.split(" ", -1);
        try {
            return parts.length != PARTS ? Optional.empty()
                    : Optional.of(new FileState(FileTime.from(Instant.parse(parts[0])), Long.parseLong(parts[1]), parts[2]));
        } catch (DateTimeParseException | NumberFormatException e) {
            return Optional.empty();
        }
    }

    /** Returns time, size and content on one line. */
    public String toText() {
        return modified + " " + size + " " + content;
    }

    FileState withContent(byte[] bytes) {
        return new FileState(modified, size, size > MAX_HASHED_BYTES ? "" : HexFormat.of().formatHex(sha256().digest(bytes)));
    }

    /** Returns whether time and size are equal. */
    public boolean hasSameMetadata(FileState other) {
        return modified.equals(other.modified) && size == other.size;
    }

    /** Returns whether both states have the same content. */
    public boolean hasSameContent(FileState other) {
        return size == other.size
                && (content.isEmpty() || other.content.isEmpty() ? hasSameMetadata(other) : content.equals(other.content));
    }

    /** Returns whether the file exists with other content. */
    boolean differsFrom(Path file) throws IOException {
        return Files.exists(file) && !hasSameContent(of(file));
    }

    /** Counts the bytes read, because another program may write during the read. */
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
