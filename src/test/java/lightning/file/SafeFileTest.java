package lightning.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SafeFileTest {
    @TempDir
    Path folder;

    @Test
    void newFile_holdsTheContent() throws IOException {
        SafeFile.write(folder.resolve("a"), out -> out.write(new byte[] {1, 2, 3}));
        assertThat(folder.resolve("a")).hasBinaryContent(new byte[] {1, 2, 3});
        assertThat(names()).containsExactly("a");
    }

    @Test
    void closingTheStream_doesNoHarm() throws IOException {
        SafeFile.write(folder.resolve("a"), out -> {
            out.write(7);
            out.close();
        });
        assertThat(folder.resolve("a")).hasBinaryContent(new byte[] {7});
    }

    @Test
    void failedWrite_leavesTheOldFileAndNothingElse() throws IOException {
        Path file = Files.writeString(folder.resolve("a"), "old");
        assertThatThrownBy(() -> SafeFile.write(file, out -> {
            out.write(new byte[100_000]);
            throw new IOException("disk full");
        })).isInstanceOf(IOException.class).hasMessage("disk full");
        assertThat(file).hasContent("old");
        assertThat(names()).containsExactly("a");
    }

    @Test
    void replacedFile_isTheOldOneUntilTheContentIsComplete() throws IOException {
        Path file = Files.writeString(folder.resolve("a"), "old");
        SafeFile.write(file, out -> {
            out.write(new byte[100_000]);
            assertThat(file).hasContent("old");
        });
        assertThat(file).hasSize(100_000);
    }

    @Test
    void replacedFile_keepsItsPermissions() throws IOException {
        Path file = Files.writeString(folder.resolve("a"), "old");
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-r-----"));
        SafeFile.write(file, out -> out.write(1));
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(file))).isEqualTo("rw-r-----");
    }

    @Test
    void symbolicLink_staysALink() throws IOException {
        Path file = Files.writeString(folder.resolve("a"), "old");
        Path link = Files.createSymbolicLink(folder.resolve("b"), file);
        SafeFile.write(link, out -> out.write('x'));
        assertThat(link).isSymbolicLink();
        assertThat(file).hasContent("x");
    }

    @Test
    void folder_isRefused() {
        assertThatThrownBy(() -> SafeFile.write(folder, out -> {})).isInstanceOf(IOException.class)
                .hasMessageContaining("is a folder");
    }

    private List<String> names() throws IOException {
        try (var files = Files.list(folder)) {
            return files.map(p -> p.getFileName().toString()).toList();
        }
    }
}
