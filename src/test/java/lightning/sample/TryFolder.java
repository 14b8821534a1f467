package lightning.sample;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.base.file.TemporaryFolder;

/** Temporary folder for one try of a property, or for all of them. Closing it deletes it with everything in it. */
public final class TryFolder implements AutoCloseable {
    private final Path path;

    /** @throws IOException if the folder cannot be created */
    public TryFolder() throws IOException {
        path = Files.createTempDirectory("lightning-try");
    }

    public Path path() {
        return path;
    }

    /** Returns the place of a file in the folder, which need not exist. */
    public Path file(String name) {
        return path.resolve(name);
    }

    @Override
    public void close() throws IOException {
        TemporaryFolder.delete(path);
    }
}
