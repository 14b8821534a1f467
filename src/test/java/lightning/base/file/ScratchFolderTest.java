package lightning.base.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests folders that are removed with their process. */
class ScratchFolderTest {
    @TempDir
    Path place;

    private List<Path> folders() throws IOException {
        try (Stream<Path> all = Files.list(place)) {
            return all.toList();
        }
    }

    @Test
    void folder_isPrivateAndRemovedOnClose() throws IOException {
        try (ScratchFolder scratch = ScratchFolder.createIn(place)) {
            Path file = scratch.file("a");
            scratch.write(file, channel -> channel.write(ByteBuffer.wrap(new byte[] {1, 2})));
            assertThat(file).hasBinaryContent(new byte[] {1, 2});
            assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file))).isEqualTo("rw-------");
            assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(folders().getFirst()))).isEqualTo("rwx------");
        }
        assertThat(folders()).isEmpty();
    }

    @Test
    void failedWrite_leavesNoFile() throws IOException {
        try (ScratchFolder scratch = ScratchFolder.createIn(place)) {
            assertThatThrownBy(() -> scratch.write(scratch.file("a"), channel -> {
                channel.write(ByteBuffer.wrap(new byte[10]));
                throw new IOException("full");
            })).hasMessage("full");
            assertThat(scratch.file("a")).doesNotExist();
        }
    }

    @Test
    void folderOfEndedProcess_isRemoved_lockedFolderIsNot() throws IOException {
        Path staleFolder = Files.createDirectory(place.resolve("lightning-scratch-00000000-0000-0000-0000-000000000000"));
        Files.writeString(staleFolder.resolve("in-use"), "");
        Files.writeString(staleFolder.resolve("rows-1"), "x");
        Path other = Files.createDirectory(place.resolve("lightning-scratch-mine"));
        Path halfMade = Files.createDirectory(place.resolve("lightning-scratch-00000000-0000-0000-0000-000000000001"));
        try (ScratchFolder first = ScratchFolder.createIn(place); ScratchFolder second = ScratchFolder.createIn(place)) {
            assertThat(staleFolder).doesNotExist();
            assertThat(other).exists();
            assertThat(halfMade).exists();
            assertThat(first.file("in-use")).exists();
            assertThat(second.file("in-use")).exists();
        }
    }

    @Test
    void filesOutsideOfKilledProcess_areRemoved_unlessReplaced(@TempDir Path outside) throws Exception {
        Path own = outside.resolve("own");
        Path replaced = outside.resolve("replaced");
        Process other = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                System.getProperty("java.class.path"), ScratchHolder.class.getName(), place.toString(), own.toString(), replaced.toString())
                .start();
        try {
            assertThat(other.inputReader().readLine()).isEqualTo("made");
            ScratchFolder.createIn(place).close();
            assertThat(own).exists();
            other.destroyForcibly().waitFor();
            Files.delete(replaced);
            Files.write(replaced, new byte[100]);
            ScratchFolder.createIn(place).close();
            assertThat(own).doesNotExist();
            assertThat(replaced).exists();
        } finally {
            other.destroyForcibly();
        }
    }

    @Test
    void folderOfRunningProcess_isNotRemoved() throws Exception {
        Process other = new ProcessBuilder(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "-cp",
                System.getProperty("java.class.path"), ScratchHolder.class.getName(), place.toString()).start();
        try {
            assertThat(other.inputReader().readLine()).isEqualTo("made");
            List<Path> folders = folders();
            ScratchFolder.createIn(place).close();
            assertThat(folders()).hasSize(2).containsExactlyInAnyOrderElementsOf(folders);
            other.destroyForcibly().waitFor();
            ScratchFolder.createIn(place).close();
            assertThat(folders()).isEmpty();
        } finally {
            other.destroyForcibly();
        }
    }

    @Test
    void parentThatIsNoFolder_isRejected() {
        assertThatThrownBy(() -> ScratchFolder.createIn(place.resolve("none"))).hasMessageContaining("none")
                .hasMessageContaining("is not a folder");
    }
}
