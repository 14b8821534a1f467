package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import lightning.sample.ByteFuzzer;
import lightning.sample.Slow;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Texts from the grammar with a few errors, and mutations of them: the reader returns a scene or throws its own exception;
 * {@link ByteFuzzer} documents the options.
 */
@Slow
class JenFuzzTest {
    private static final int FILES = ByteFuzzer.tryCount(25_000);
    private static final List<byte[]> INSERTIONS =
            Stream.of(" ", "{", "}", "\"", "#", "\n", "-", ".", "e9", "\\", "\"a b\"", "\u2028", "𝐀")
                    .map(bit -> bit.getBytes(StandardCharsets.UTF_8)).toList();

    @TempDir
    Path folder;

    @BeforeEach
    void writeMesh() throws IOException {
        Files.writeString(folder.resolve(RandomJenText.MESH), """
                ply
                format ascii 1.0
                element vertex 3
                property float x
                property float y
                property float z
                element face 1
                property list uchar int vertex_indices
                end_header
                0 0 0  1 0 0  0 1 0
                3 0 1 2
                """);
    }

    @Test
    @Timeout(600)
    void grammarFiles_yieldSceneOrProblem() {
        int readCount = 0;
        for (int i = 0; i < FILES / 2; i++) {
            var grammar = new RandomJenText(ByteFuzzer.random(i));
            if (isReadable(grammar.appendFile(), i)) {
                readCount++;
            }
        }
        assertThat(readCount / (FILES / 2.0)).as("share of files that can be read").isBetween(0.4, 0.6);
    }

    @Test
    @Timeout(600)
    void mutatedFiles_yieldSceneOrProblem() {
        List<byte[]> pool = new ArrayList<>();
        for (int i = 0; i < 200; i++) {
            pool.add(new RandomJenText(ByteFuzzer.random(i)).appendFile().getBytes(StandardCharsets.UTF_8));
        }
        int readCount = 0;
        for (int i = 0; i < FILES / 2; i++) {
            byte[] bytes = ByteFuzzer.mutate(pool, ByteFuzzer.random(i), INSERTIONS);
            var problems = new ProblemList();
            String text = SourceText.decode("fuzz", bytes, problems).text();
            if (isReadable(text, i)) {
                readCount++;
            }
        }
        assertThat(readCount / (FILES / 2.0)).as("share of files that can be read").isBetween(0.02, 0.8);
    }

    @Test
    void mutatedBytes_yieldSceneOrProblem() throws Exception {
        Path file = folder.resolve("f.jen");
        var random = ByteFuzzer.random(0);
        byte[] text = new RandomJenText(random).appendFile().getBytes(StandardCharsets.UTF_8);
        for (int i = 0; i < 200; i++) {
            Files.write(file, ByteFuzzer.mutate(List.of(text), random, INSERTIONS));
            try {
                JenReader.read(file);
            } catch (JenException e) {
                assertThat(e.problems()).isNotEmpty();
            }
        }
    }

    private boolean isReadable(String text, int number) {
        try {
            JenDocument document = JenReader.read(text, "fuzz", folder);
            if (number % 16 == 0) {
                assertThat(JenReader.read(JenWriter.write(document.scene()), "again", folder).scene()).isEqualTo(document.scene());
            }
            return true;
        } catch (JenException e) {
            assertThat(e.problems()).isNotEmpty();
            return false;
        } catch (RuntimeException | StackOverflowError e) {
            throw new AssertionError("file " + number + ":\n" + text, e);
        }
    }
}
