package lightning.editor.window.model;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import lightning.editor.window.widget.ColorTheme;
import lightning.render.image.DisplayCurve;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PreferencesTest {
    @TempDir
    private Path folder;

    @Test
    void preferences_arePersisted() {
        var first = new Preferences(folder.resolve("new"), Runnable::run);
        first.set("width", 1234.5);
        first.save();
        assertThat(new Preferences(folder.resolve("new"), Runnable::run).number("width", 1, 9999, 0)).isEqualTo(1234.5);
    }

    @Test
    void recentScenes_areLatestFirstWithoutDuplicates() {
        var preferences = new Preferences(folder, Runnable::run);
        Path a = folder.resolve("a.jen");
        Path b = folder.resolve("b.jen");
        preferences.addRecent(a);
        preferences.addRecent(b);
        preferences.addRecent(a);
        assertThat(new Preferences(folder, Runnable::run).recent()).containsExactly(a.toAbsolutePath(), b.toAbsolutePath());
    }

    @Test
    void recentScenes_areAtMostTen() {
        var preferences = new Preferences(folder, Runnable::run);
        for (int i = 0; i < 15; i++) {
            preferences.addRecent(folder.resolve(i + ".jen"));
        }
        assertThat(preferences.recent()).hasSize(10).first().isEqualTo(folder.resolve("14.jen").toAbsolutePath());
    }

    @ParameterizedTest
    @ValueSource(strings = {"NaN", "Infinity", "-Infinity", "0", "-1", "1e-300", "1e300", "199.9", "32769", "", "wide",
        "\\u00zz"})
    void numberOutOfRange_isIgnored(String damaged) throws IOException {
        Files.writeString(folder.resolve("preferences.properties"), "width=" + damaged);
        assertThat(new Preferences(folder, Runnable::run).number("width", 200, 32_768, 7)).isEqualTo(7);
    }

    @ParameterizedTest
    @ValueSource(strings = {"\n", "a\n", "\\\n"})
    void fileOfManyLines_usesProportionalMemory(String line) throws IOException {
        Files.writeString(folder.resolve("preferences.properties"), "width=300\n" + line.repeat(400_000));
        var threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long before = threads.getCurrentThreadAllocatedBytes();
        assertThat(new Preferences(folder, Runnable::run).number("width", 200, 32_768, 7)).isEqualTo(300);
        assertThat(threads.getCurrentThreadAllocatedBytes() - before).isLessThan(256L << 20);
    }

    @Test
    void valueEndingInBackslash_keepsNextLine() throws IOException {
        Files.writeString(folder.resolve("preferences.properties"), "theme=a\\\nwidth=300\n");
        assertThat(new Preferences(folder, Runnable::run).number("width", 200, 32_768, 7)).isEqualTo(300);
    }

    @Test
    void damagedValue_keepsOthers() throws IOException {
        Files.writeString(folder.resolve("preferences.properties"),
                "height=500\nrecent.0=\\u00zz\nwidth=400\ntheme=PINK\ncurve=LINEAR\nrecent.1=a\\u0000b\nrecent.2=/a.jen\n");
        var preferences = new Preferences(folder, Runnable::run);
        assertThat(preferences.number("height", 200, 900, 7)).isEqualTo(500);
        assertThat(preferences.number("width", 200, 900, 7)).isEqualTo(400);
        assertThat(preferences.enumValue("theme", ColorTheme.DARK)).isEqualTo(ColorTheme.DARK);
        assertThat(preferences.enumValue("curve", DisplayCurve.SRGB)).isEqualTo(DisplayCurve.LINEAR);
        assertThat(preferences.recent()).containsExactly(Path.of("/a.jen"));
    }

    @Test
    void invalidBytes_affectOnlyTheirValue() throws IOException {
        Files.write(folder.resolve("preferences.properties"), "theme=\u00ff\nwidth=400\n".getBytes(StandardCharsets.ISO_8859_1));
        assertThat(new Preferences(folder, Runnable::run).number("width", 200, 900, 7)).isEqualTo(400);
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void preferences_arePrivateToOwner() throws IOException {
        new Preferences(folder.resolve("new"), Runnable::run).save();
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(folder.resolve("new/preferences.properties"))))
                .isEqualTo("rw-------");
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(folder.resolve("new")))).isEqualTo("rwx------");
    }

    @Test
    void uncreatableFolder_isIgnored() throws IOException {
        Path file = Files.writeString(folder.resolve("file"), "no folder");
        var preferences = new Preferences(file, Runnable::run);
        preferences.addRecent(folder.resolve("a.jen"));
        assertThat(preferences.recent()).hasSize(1);
    }
}
