package lightning.editor.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class PresenceTest {
    @TempDir
    private Path folder;

    private Path open() {
        return folder.resolve("open");
    }

    private Path scene(String name) throws IOException {
        return Files.writeString(folder.resolve(name), Desk.TEXT);
    }

    private List<Path> told() throws IOException {
        try (Stream<Path> files = Files.list(open())) {
            return files.toList();
        }
    }

    @Test
    void sceneThatAnotherEditorHasOpen_isOpenElsewhereUntilThatLeavesIt() throws IOException {
        Path a = scene("a.jen");
        Path b = scene("b.jen");
        try (var one = new Presence(open()); var two = new Presence(open())) {
            one.open(a);
            two.open(b);
            assertThat(one.isOpenElsewhere(a)).isFalse();
            assertThat(two.isOpenElsewhere(a)).isTrue();
            one.open(b);
            assertThat(two.isOpenElsewhere(a)).isFalse();
            assertThat(two.isOpenElsewhere(b)).isTrue();
            one.close();
            assertThat(two.isOpenElsewhere(b)).isFalse();
        }
        assertThat(told()).isEmpty();
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void linkToTheSameScene_isTheSame() throws IOException {
        Path a = scene("a\nb.jen");
        Path link = Files.createSymbolicLink(folder.resolve("c.jen"), a);
        try (var one = new Presence(open()); var two = new Presence(open())) {
            one.open(link);
            two.open(a);
            assertThat(two.isOpenElsewhere(a)).isTrue();
        }
    }

    @Test
    void killedEditor_isGoneAtOnce() throws Exception {
        Path scene = scene("a.jen");
        Process other = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                System.getProperty("java.class.path"), Editor.class.getName(), open().toString(), scene.toString()).start();
        try (var here = new Presence(open())) {
            assertThat((char) other.getInputStream().read()).isEqualTo('o');
            here.open(scene);
            assertThat(here.isOpenElsewhere(scene)).isTrue();
            other.destroyForcibly().waitFor();
            assertThat(here.isOpenElsewhere(scene)).isFalse();
            assertThat(told()).as("what it left, young as it is").hasSize(2);
            for (Path file : told()) {
                Files.setLastModifiedTime(file, FileTime.fromMillis(1_000_000));
            }
            assertThat(here.isOpenElsewhere(scene)).isFalse();
            assertThat(told()).as("its own").hasSize(1);
        } finally {
            other.destroyForcibly();
        }
    }

    /** A process that has a scene open until it is killed. */
    public static final class Editor {
        public static void main(String[] arguments) throws IOException {
            var presence = new Presence(Path.of(arguments[0]));
            presence.open(Path.of(arguments[1]));
            System.out.write('o');
            System.out.flush();
            while (System.in.read() >= 0) {
                // Whoever started it holds its input.
            }
            presence.close();
        }
    }

    @Test
    void strayFiles_areNoTrouble() throws IOException {
        Path scene = scene("a.jen");
        try (var here = new Presence(open())) {
            here.open(scene);
            Files.write(open().resolve("x.open"), new byte[] {(byte) 0xFF});
            Files.createDirectory(open().resolve("y.open"));
            assertThat(here.isOpenElsewhere(scene)).isFalse();
        }
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void whatIsOpen_isTheUsersOwnAffair() throws IOException {
        try (var here = new Presence(open())) {
            here.open(scene("a.jen"));
            assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(open()))).isEqualTo("rwx------");
        }
    }
}
