package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import lightning.editor.window.widget.ColorTheme;
import lightning.sample.ByteFuzzer;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Fuzz test: preferences with random errors are read and written without exceptions. */
@Slow
class PreferencesFuzzTest {
    private static final int TRIES = ByteFuzzer.tryCount(1_000);
    private static final List<byte[]> PREFERENCES =
            bytes("#Lightning\nwidth=1280.0\nheight=800\nrecent.0=/scenes/a b.jen\nrecent.1=/scenes/b.jen\ntheme=DARK\n",
                    "precision=EXACT\ncurve=LINEAR\nrecent.0=\\u00e4.jen\n");
    private static final List<byte[]> BITS =
            bytes("\\u", "\\u00zz", "\\", "\n", "=", ":", "\u0000", "NaN", "Infinity", "1e999", "0x1p3", "recent.0=", "#", "𝐀");

    @TempDir
    private Path folder;

    @Test
    void anyFile_canBeReadAndWritten() throws IOException {
        Path file = folder.resolve("preferences.properties");
        int recent = 0;
        for (int i = 0; i < TRIES; i++) {
            byte[] bytes = ByteFuzzer.mutate(PREFERENCES, ByteFuzzer.random(i), BITS);
            Files.write(file, bytes);
            assertThatCode(() -> {
                var preferences = new Preferences(folder, Runnable::run);
                assertThat(preferences.number("width", 200, 32_768, 1)).isFinite();
                assertThat(preferences.number("height", 200, 32_768, 1)).isFinite();
                preferences.enumValue("theme", ColorTheme.DARK);
                List<Path> files = preferences.recent();
                preferences.set("width", 7);
                preferences.save();
                assertThat(new Preferences(folder, Runnable::run).recent()).isEqualTo(files);
                assertThat(new Preferences(folder, Runnable::run).number("width", 1, 9, 0)).isEqualTo(7);
            }).as("try " + i + ": " + new String(bytes, StandardCharsets.UTF_8)).doesNotThrowAnyException();
            recent += new Preferences(folder, Runnable::run).recent().isEmpty() ? 0 : 1;
        }
        assertThat(recent).isBetween(TRIES / 20, TRIES - 1);
    }

    private static List<byte[]> bytes(String... texts) {
        return Stream.of(texts).map(text -> text.getBytes(StandardCharsets.UTF_8)).toList();
    }
}
