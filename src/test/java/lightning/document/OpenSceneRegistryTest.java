package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatNoException;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class OpenSceneRegistryTest {
    @TempDir
    private Path folder;

    private Path openFile() {
        return folder.resolve("open");
    }

    private Path scene(String name) throws IOException {
        return Files.writeString(folder.resolve(name), DeskScene.TEXT);
    }

    private List<Path> registeredFiles() throws IOException {
        try (Stream<Path> files = Files.list(openFile())) {
            return files.toList();
        }
    }

    @Test
    void sceneOfOtherEditor_isOpenElsewhereUntilClosed() throws IOException {
        Path a = scene("a.jen");
        Path b = scene("b.jen");
        try (var one = new OpenSceneRegistry(openFile()); var two = new OpenSceneRegistry(openFile())) {
            one.register(a);
            two.register(b);
            assertThat(one.isOpenElsewhere(a)).isFalse();
            assertThat(two.isOpenElsewhere(a)).isTrue();
            one.register(b);
            assertThat(two.isOpenElsewhere(a)).isFalse();
            assertThat(two.isOpenElsewhere(b)).isTrue();
            one.close();
            assertThat(two.isOpenElsewhere(b)).isFalse();
        }
        assertThat(registeredFiles()).isEmpty();
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void linkToSameScene_isSameScene() throws IOException {
        Path a = scene("a\nb.jen");
        Path link = Files.createSymbolicLink(folder.resolve("c.jen"), a);
        try (var one = new OpenSceneRegistry(openFile()); var two = new OpenSceneRegistry(openFile())) {
            one.register(link);
            two.register(a);
            assertThat(two.isOpenElsewhere(a)).isTrue();
        }
    }

    @Test
    void killedEditor_isUnregisteredImmediately() throws Exception {
        Path scene = scene("a.jen");
        Process other = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                System.getProperty("java.class.path"), Editor.class.getName(), openFile().toString(), scene.toString()).start();
        try (var here = new OpenSceneRegistry(openFile())) {
            assertThat((char) other.getInputStream().read()).isEqualTo('o');
            here.register(scene);
            assertThat(here.isOpenElsewhere(scene)).isTrue();
            other.destroyForcibly().waitFor();
            assertThat(here.isOpenElsewhere(scene)).isFalse();
            assertThat(registeredFiles()).as("recent file of the ended process").hasSize(2);
            for (Path file : registeredFiles()) {
                Files.setLastModifiedTime(file, FileTime.fromMillis(1_000_000));
            }
            assertThat(here.isOpenElsewhere(scene)).isFalse();
            assertThat(registeredFiles()).as("own file").hasSize(1);
        } finally {
            other.destroyForcibly();
        }
    }

    /** Process that has a scene open until it is killed. */
    public static final class Editor {
        public static void main(String[] arguments) throws IOException {
            var presence = new OpenSceneRegistry(Path.of(arguments[0]));
            presence.register(Path.of(arguments[1]));
            System.out.write('o');
            System.out.flush();
            while (System.in.read() >= 0) {
                // The parent process holds its input open.
            }
            presence.close();
        }
    }

    @Test
    void strayFiles_areIgnored() throws IOException {
        Path scene = scene("a.jen");
        try (var here = new OpenSceneRegistry(openFile())) {
            here.register(scene);
            Files.write(openFile().resolve("x.open"), new byte[] {(byte) 0xFF});
            Files.createDirectory(openFile().resolve("y.open"));
            assertThat(here.isOpenElsewhere(scene)).isFalse();
        }
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void folder_isPrivateToUser() throws IOException {
        try (var here = new OpenSceneRegistry(openFile())) {
            here.register(scene("a.jen"));
            assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(openFile()))).isEqualTo("rwx------");
        }
    }

    @Test
    void registration_waitsForAnotherEditorThatLooks() throws Exception {
        Path common = folder.resolve("busy");
        Path scene = Files.writeString(folder.resolve("busy.jen"), "");
        var isDone = new AtomicBoolean();
        try (var first = new OpenSceneRegistry(common); var looking = new OpenSceneRegistry(common)) {
            first.register(scene);
            Thread other = Thread.ofPlatform().start(() -> {
                while (!isDone.get()) {
                    try {
                        looking.isOpenElsewhere(scene);
                    } catch (IOException e) {
                        // A file that was listed is gone.
                    }
                }
            });
            try {
                for (int i = 0; i < 3000; i++) {
                    try (var registry = new OpenSceneRegistry(common)) {
                        assertThatNoException().isThrownBy(() -> registry.register(scene));
                    }
                }
            } finally {
                isDone.set(true);
                other.join();
            }
        }
    }
}
