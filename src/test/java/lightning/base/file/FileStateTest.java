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

/** What is remembered of a file that others write. */
class FileStateTest {
    private static final int READS = 3000;

    @TempDir
    private Path folder;

    @Test
    void fileBeingWritten_sizeMatchesContent() throws Exception {
        Path file = folder.resolve("a.jen");
        // All of one letter, so that a text of which a part was read before and a part after is one of them too.
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
