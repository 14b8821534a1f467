package lightning.document.motion;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import lightning.base.text.PrintableText;
import lightning.sample.ByteFuzzer;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Fuzz test of motion paths: each mutated file gives a valid path or a one-line error message. */
@Slow
class MotionPathFuzzTest {
    private static final int TRIES = ByteFuzzer.tryCount(15_000);
    private static final List<byte[]> PATHS =
            bytes("lightning-path 1\nat 0 4 2  direction 0 -1 -1\nat 2.3 3.6 1.4 direction -1 -1 0 # last\n",
                    "\uFEFFlightning-path 1\r\nevery 7\r\n\r\n# one\r\n\tat -1e-3 .5 +6. direction 1e3 0 0\r\n");
    private static final List<byte[]> BITS =
            bytes(" ", "\n", "\r", "#", "at ", "direction ", "every ", "NaN", "1e999", "0x1p3", "1d", "-0", "\u2028", "\f",
                    "\u001B[31m", "𝐀".repeat(60), "99999999999");

    @TempDir
    private Path folder;

    @Test
    void anyText_isPathOrRejected() throws IOException {
        Path file = folder.resolve("a.path");
        int right = 0;
        for (int i = 0; i < TRIES; i++) {
            byte[] bytes = ByteFuzzer.mutate(PATHS, ByteFuzzer.random(i), BITS);
            try {
                RecordedShot path = i % 16 == 0 ? MotionPathFile.load(Files.write(file, bytes), "key")
                        : MotionPathFile.read(new String(bytes, StandardCharsets.UTF_8), file.toString(), "key");
                assertThat(MotionPathFile.read(MotionPathFile.write(path), "again", "key")).isEqualTo(path);
                right++;
            } catch (IOException e) {
                assertThat(e.getMessage()).startsWith(file + ":").matches(PrintableText::isPrintable, "is visible").hasSizeLessThan(1000);
            } catch (RuntimeException e) {
                throw new AssertionError("try " + i + ": " + new String(bytes, StandardCharsets.UTF_8), e);
            }
        }
        assertThat(right).isBetween(TRIES / 50, TRIES - TRIES / 10);
    }

    private static List<byte[]> bytes(String... texts) {
        return Stream.of(texts).map(text -> text.getBytes(StandardCharsets.UTF_8)).toList();
    }
}
