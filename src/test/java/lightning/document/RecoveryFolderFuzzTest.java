package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import lightning.base.file.FileState;
import lightning.sample.ByteFuzzer;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Fuzz test of recovery files: each mutated file is found with its scene or skipped. */
@Slow
class RecoveryFolderFuzzTest {
    private static final int TRIES = ByteFuzzer.tryCount(2_000);
    private static final List<byte[]> BITS =
            Stream.of("\n", "-", " for ", "/", "\u0000", "..", "#", "", "99999999999999999999", "-1", "𝐀", " process ")
                    .map(bit -> bit.getBytes(StandardCharsets.UTF_8)).toList();

    @TempDir
    private Path folder;

    @Test
    void storedFile_isListedOrSkipped() throws IOException {
        new RecoveryFolder(folder, "999999999999-1").store(Path.of("/scenes/a b.jen"), FileState.MISSING, "jen 1\n");
        Path kept;
        try (Stream<Path> files = Files.list(folder)) {
            kept = files.findFirst().orElseThrow();
        }
        List<byte[]> pool = new ArrayList<>(List.of(Files.readAllBytes(kept)));
        // One text has only the header line, so that mutations hit it.
        String text = new String(pool.getFirst(), StandardCharsets.UTF_8);
        pool.add(text.substring(0, text.indexOf("/scenes")).getBytes(StandardCharsets.UTF_8));
        int found = 0;
        for (int i = 0; i < TRIES; i++) {
            byte[] bytes = ByteFuzzer.mutate(pool, ByteFuzzer.random(i), BITS);
            Files.write(kept, bytes);
            try {
                List<RecoveryFolder.RecoverableScene> all = new RecoveryFolder(folder).list();
                assertThat(all).allSatisfy(one -> {
                    assertThat(one.file()).isAbsolute();
                    assertThat(one.file().getFileName()).isNotNull();
                });
                found += all.size();
            } catch (RuntimeException | AssertionError e) {
                throw new AssertionError("try " + i + ": " + new String(bytes, StandardCharsets.UTF_8), e);
            }
        }
        assertThat(found).isBetween(TRIES / 20, TRIES - TRIES / 20);
    }

    /** Checks the fixed cases that random mutations may miss. */
    @Test
    void invalidProcess_isACrashAndRootIsNoScene() throws IOException {
        Files.createDirectories(folder);
        Files.writeString(folder.resolve("a.kept.jen"),
                "# Lightning kept this of process - for " + Path.of("a.jen").toAbsolutePath() + "\njen 1\n");
        Files.writeString(folder.resolve("b.kept.jen"), "# Lightning kept this of process 999999999999-1 for /\njen 1\n");
        Files.writeString(folder.resolve("c.kept.jen"), "# Lightning kept this of process 999999999999-1 for a.jen\njen 1\n");
        assertThat(new RecoveryFolder(folder).list()).singleElement().satisfies(
                found -> assertThat(found.recoveryFile()).hasFileName("a.kept.jen"));
    }
}
