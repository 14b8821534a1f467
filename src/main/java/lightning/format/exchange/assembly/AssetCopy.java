package lightning.format.exchange.assembly;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import lightning.base.file.AtomicFile;
import lightning.base.file.ContentHash;
import lightning.base.file.ParentFolder;
import lightning.base.file.RegularFile;
import org.jspecify.annotations.Nullable;

/**
 * File to place next to an imported scene.
 *
 * @param target path of the copy
 * @param source file to copy; null if {@code bytes} is given
 * @param bytes content; null if {@code source} is given
 */
public record AssetCopy(Path target, @Nullable Path source, byte @Nullable [] bytes) {
    private static final String EXPECTED_FILE = "a file to copy next to the scene";

    /** Returns whether a file with this content is at the target. */
    boolean isWritten() throws IOException {
        return Files.exists(target) && (source != null
                ? Files.isSameFile(source, target) || RegularFile.haveSameContent(source, target, EXPECTED_FILE)
                : Files.size(target) == requireNonNull(bytes).length
                        && Arrays.equals(RegularFile.readBytes(target, EXPECTED_FILE, bytes.length), bytes));
    }

    /** Returns whether a file of other content is at the target. */
    boolean isDifferent() throws IOException {
        return Files.exists(target) && !isWritten();
    }

    /** Returns a copy of the same content to another path. */
    AssetCopy to(Path newTarget) {
        return new AssetCopy(newTarget, source, bytes);
    }

    /** Returns the hash of the content. */
    ContentHash hash() throws IOException {
        return source == null ? ContentHash.of(bytes) : ContentHash.of(source);
    }

    /** Writes the content to the target, and its folders. */
    void write() throws IOException {
        Files.createDirectories(ParentFolder.of(target));
        AtomicFile.write(target, out -> {
            if (source != null) {
                try (InputStream in = RegularFile.open(source, EXPECTED_FILE)) {
                    in.transferTo(out);
                }
            } else {
                out.write(bytes);
            }
        });
    }
}
