package lightning.base.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests states of files that other programs write. */
class FileStateTest {
    private static final int READS = 3000;

    @TempDir
    private Path folder;

    @Test
    void fileBeingWritten_sizeMatchesContent() throws Exception {
        Path file = folder.resolve("a.jen");
        // Each text repeats one letter, so that a torn read is also one of the known texts.
        Map<String, Long> sizes = new HashMap<>();
        for (String text : new String[] {"", "a", "aaa"}) {
            FileState state = FileState.of(Files.writeString(file, text));
            sizes.put(state.content(), state.size());
        }
        AtomicBoolean enough = new AtomicBoolean();
        Thread writer = Thread.ofPlatform().start(() -> {
            while (!enough.get()) {
                write(file, "a");
                write(file, "aaa");
            }
        });
        try {
            for (int i = 0; i < READS; i++) {
                FileState seen = FileState.of(file);
                assertThat(seen.size()).isEqualTo(sizes.get(seen.content()));
            }
        } finally {
            enough.set(true);
            writer.join();
        }
    }

    private static void write(Path file, String text) {
        try {
            Files.writeString(file, text);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
