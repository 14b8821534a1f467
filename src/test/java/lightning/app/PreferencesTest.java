package lightning.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PreferencesTest {
    @TempDir
    private Path folder;

    @Test
    void preferences_areThereInTheNextRun() {
        var first = new Preferences(folder.resolve("new"));
        first.set("width", 1234.5);
        first.save();
        assertThat(new Preferences(folder.resolve("new")).number("width", 0)).isEqualTo(1234.5);
    }

    @Test
    void recentScenes_areTheLatestFirstAndEachOnce() {
        var preferences = new Preferences(folder);
        Path a = folder.resolve("a.jen");
        Path b = folder.resolve("b.jen");
        preferences.opened(a);
        preferences.opened(b);
        preferences.opened(a);
        assertThat(new Preferences(folder).recent()).containsExactly(a.toAbsolutePath(), b.toAbsolutePath());
    }

    @Test
    void recentScenes_areAtMostTen() {
        var preferences = new Preferences(folder);
        for (int i = 0; i < 15; i++) {
            preferences.opened(folder.resolve(i + ".jen"));
        }
        assertThat(preferences.recent()).hasSize(10).first().isEqualTo(folder.resolve("14.jen").toAbsolutePath());
    }

    @Test
    void damagedFile_countsAsEmpty() throws IOException {
        Files.writeString(folder.resolve("preferences.properties"), "width=\\u00zz");
        assertThat(new Preferences(folder).number("width", 7)).isEqualTo(7);
    }

    @Test
    void folderThatCannotBeMade_disturbsNobody() throws IOException {
        Path file = Files.writeString(folder.resolve("file"), "no folder");
        var preferences = new Preferences(file);
        preferences.opened(folder.resolve("a.jen"));
        assertThat(preferences.recent()).hasSize(1);
    }
}
