package lightning.format.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import lightning.base.work.Progress;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tokens and numbers of text files. */
class TextTokenizerTest {
    @TempDir
    private Path folder;

    @Test
    @Slow
    void numbers_areParsedToNearestDouble() throws IOException, MeshException {
        var random = new SplittableRandom(7);
        var text = new StringBuilder(
                "0 -0 .5 5. -1.5e-3 1e22 1e23 123456789012345678 9007199254740993 0.1e+05 4.9e-324 1E5 00000000000000000000001");
        for (int i = 0; i < 2000; i++) {
            double v = Double.longBitsToDouble(random.nextLong());
            text.append(' ').append(Double.isFinite(v) ? v : 0).append(' ').append((float) random.nextDouble(-100, 100)).append(' ')
                    .append(String.format(Locale.ROOT, "%." + random.nextInt(10) + "f", random.nextDouble(1e6)));
        }
        for (String word : text.toString().split(" ")) {
            assertThat(number(word)).as(word).isEqualTo(Double.parseDouble(word));
        }
    }

    @Test
    void invalidNumbers_areRejected() {
        for (String word : List.of("nan", "inf", "1e999", "1d", "0x1p3", "1e", "e1", "-", ".", "1.2.3", "1e+", "--1", "1e1.0", "١")) {
            assertThatExceptionOfType(MeshException.class).as(word).isThrownBy(() -> number(word))
                    .withMessageContaining("line 1: it must be a decimal number");
        }
    }

    @Test
    void lines_areCounted() throws IOException, MeshException {
        try (ByteSource bytes = source("a  b\n\n c\r\nd")) {
            var text = new TextTokenizer(bytes);
            assertThat(text.readToken() && text.isToken("a") && text.readToken() && text.isToken("b")).isTrue();
            assertThat(text.readToken()).isFalse();
            assertThat(text.nextLine()).isTrue();
            assertThat(text.readToken()).isFalse();
            assertThat(text.nextLine() && text.readToken() && text.isToken("c") && text.line() == 3).isTrue();
            assertThat(text.nextLine() && text.readToken() && text.isToken("d") && text.line() == 4).isTrue();
            assertThat(text.nextLine()).isFalse();
        }
    }

    @Test
    void tooLongToken_isRejected() {
        assertThatExceptionOfType(MeshException.class).isThrownBy(() -> number("1".repeat(2000)))
                .withMessageContaining("line 1: a word must have at most 1000 bytes, found more");
    }

    private double number(String word) throws IOException, MeshException {
        try (ByteSource bytes = source(word)) {
            var text = new TextTokenizer(bytes);
            assertThat(text.readToken()).isTrue();
            return text.number("it");
        }
    }

    private ByteSource source(String text) throws IOException, MeshException {
        return ByteSource.open(Files.writeString(folder.resolve("a"), text), Progress.NONE);
    }
}
