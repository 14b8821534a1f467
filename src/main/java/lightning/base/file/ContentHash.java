package lightning.base.file;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import org.jspecify.annotations.Nullable;

/**
 * SHA-256 hash that identifies content.
 *
 * @param hex 64 digits, lower case
 */
public record ContentHash(String hex) {
    /** Bytes of a hash. */
    public static final int BYTES = 32;
    private static final int BUFFER = 1 << 16;

    public ContentHash {
        if (!hex.matches("[0-9a-f]{64}")) {
            throw new IllegalArgumentException("a hash must be 64 hexadecimal digits");
        }
    }

    /** Returns a hash of {@value #BYTES} bytes. */
    public static ContentHash ofBytes(byte[] bytes) {
        return new ContentHash(HexFormat.of().formatHex(bytes));
    }

    /** Returns its {@value #BYTES} bytes. */
    public byte[] bytes() {
        return HexFormat.of().parseHex(hex);
    }

    /** Hashes bytes in memory. */
    public static ContentHash of(byte @Nullable [] content) {
        return ofBytes(digest().digest(content));
    }

    /** Hashes a file of any length. */
    public static ContentHash of(Path file) throws IOException {
        MessageDigest digest = digest();
        byte[] buffer = new byte[BUFFER];
        try (InputStream in = Files.newInputStream(file)) {
            for (int n = in.read(buffer); n >= 0; n = in.read(buffer)) {
                digest.update(buffer, 0, n);
            }
        }
        return ofBytes(digest.digest());
    }

    static MessageDigest digest() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java runtime has SHA-256", e);
        }
    }
}
