package lightning.jen;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Files made from the grammar with a few mistakes, and mutations of them: whatever comes, the reader
 * answers with a scene or with its own error. {@code -Dlightning.fuzz=N} runs N files, from another
 * start with {@code -Dlightning.fuzz.seed=S}.
 */
class FuzzTest {
    private static final int FILES = Integer.getInteger("lightning.fuzz", 100_000);
    private static final long SEED = Long.getLong("lightning.fuzz.seed", 1);

    @TempDir
    Path folder;

    @Test
    @Timeout(600)
    void filesFromTheGrammar_giveASceneOrAProblem() {
        int read = 0;
        for (int i = 0; i < FILES / 2; i++) {
            var grammar = new Grammar(new SplittableRandom(SEED + i));
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
            pool.add(new Grammar(new SplittableRandom(SEED + i)).file().getBytes(StandardCharsets.UTF_8));
        }
        int read = 0;
        for (int i = 0; i < FILES / 2; i++) {
            byte[] bytes = mutated(pool, new SplittableRandom(SEED + i));
            var problems = new Problems();
            String text = Source.decode("fuzz", bytes, problems).text();
            if (reads(text, i)) {
                read++;
            }
        }
        assertThat(read).isBetween(FILES / 100, FILES / 2 - FILES / 10);
    }

    @Test
    void mutatedBytes_giveASceneOrAProblem() throws Exception {
        Path file = folder.resolve("f.jen");
        var random = new SplittableRandom(SEED);
        byte[] text = new Grammar(random).file().getBytes(StandardCharsets.UTF_8);
        for (int i = 0; i < 200; i++) {
            Files.write(file, mutated(List.of(text), random));
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

    private static byte[] mutated(List<byte[]> pool, SplittableRandom random) {
        byte[] bytes = pool.get(random.nextInt(pool.size())).clone();
        for (int i = random.nextInt(3); i >= 0; i--) {
            int at = random.nextInt(bytes.length + 1);
            int to = Math.min(bytes.length, at + random.nextInt(8));
            bytes = switch (random.nextInt(4)) {
                case 0 -> join(bytes, 0, at, new byte[] {(byte) random.nextInt(256)}, bytes, at);
                case 1 -> join(bytes, 0, at, new byte[0], bytes, to);
                case 2 -> {
                    byte[] other = pool.get(random.nextInt(pool.size()));
                    yield join(bytes, 0, at, new byte[] {' '}, other, random.nextInt(other.length + 1));
                }
                default -> join(bytes, 0, at, " {}\"#\n-.e9".substring(random.nextInt(9)).getBytes(StandardCharsets.UTF_8), bytes, at);
            };
        }
        return bytes;
    }

    private static byte[] join(byte[] a, int from, int to, byte[] between, byte[] b, int rest) {
        byte[] all = new byte[to - from + between.length + b.length - rest];
        System.arraycopy(a, from, all, 0, to - from);
        System.arraycopy(between, 0, all, to - from, between.length);
        System.arraycopy(b, rest, all, to - from + between.length, b.length - rest);
        return all;
    }
}
