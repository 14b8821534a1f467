package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import lightning.sample.Fuzz;
import lightning.sample.Slow;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Files made from the grammar with a few mistakes, and mutations of them: whatever comes, the reader
 * answers with a scene or with its own error; {@link Fuzz} tells the options.
 */
@Slow
class FuzzTest {
    private static final int FILES = Fuzz.tries(25_000);
    private static final List<byte[]> BITS = Stream.of(" ", "{", "}", "\"", "#", "\n", "-", ".", "e9", "\\", "\"a b\"", "\u2028", "𝐀")
            .map(bit -> bit.getBytes(StandardCharsets.UTF_8)).toList();

    @TempDir
    Path folder;

    @BeforeEach
    void writeMesh() throws IOException {
        Files.writeString(folder.resolve(Grammar.MESH), """
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
    void filesFromTheGrammar_giveASceneOrAProblem() {
        int read = 0;
        for (int i = 0; i < FILES / 2; i++) {
            var grammar = new Grammar(Fuzz.random(i));
            if (reads(grammar.file(), i)) {
                read++;
            }
        }
        assertThat(read / (FILES / 2.0)).as("share of files that can be read").isBetween(0.4, 0.6);
    }

    @Test
    @Timeout(600)
    void mutatedFiles_giveASceneOrAProblem() {
        List<byte[]> pool = new ArrayList<>();
        for (int i = 0; i < 200; i++) {
            pool.add(new Grammar(Fuzz.random(i)).file().getBytes(StandardCharsets.UTF_8));
        }
        int read = 0;
        for (int i = 0; i < FILES / 2; i++) {
            byte[] bytes = Fuzz.mutated(pool, Fuzz.random(i), BITS);
            var problems = new Problems();
            String text = Source.decode("fuzz", bytes, problems).text();
            if (reads(text, i)) {
                read++;
            }
        }
        assertThat(read / (FILES / 2.0)).as("share of files that can be read").isBetween(0.02, 0.8);
    }

    @Test
    void mutatedBytes_giveASceneOrAProblem() throws Exception {
        Path file = folder.resolve("f.jen");
        var random = Fuzz.random(0);
        byte[] text = new Grammar(random).file().getBytes(StandardCharsets.UTF_8);
        for (int i = 0; i < 200; i++) {
            Files.write(file, Fuzz.mutated(List.of(text), random, BITS));
            try {
                JenReader.read(file);
            } catch (JenException e) {
                assertThat(e.problems()).isNotEmpty();
            }
        }
    }

    private boolean reads(String text, int number) {
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
