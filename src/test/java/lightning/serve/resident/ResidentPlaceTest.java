package lightning.serve.resident;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@DisabledOnOs(OS.WINDOWS)
class ResidentPlaceTest {
    @TempDir
    private Path folder;

    @Test
    void folderOfTheSocket_isTheUsersOnly() throws Exception {
        Path socket = ResidentPlace.in(folder.toString(), Path.of("/nowhere"), "ada");
        assertThat(socket).isEqualTo(folder.resolve("lightning/resident"));
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(socket.getParent()))).isEqualTo("rwx------");
    }

    @Test
    void withoutRuntimeFolder_itIsAmongTemporaryFiles() throws Exception {
        assertThat(ResidentPlace.in(null, folder, "ada")).isEqualTo(folder.resolve("lightning-ada/resident"));
        assertThat(ResidentPlace.in("relative", folder, "ada")).isEqualTo(folder.resolve("lightning-ada/resident"));
        assertThat(ResidentPlace.in(folder + "/missing", folder, "ada")).isEqualTo(folder.resolve("lightning-ada/resident"));
    }

    @Test
    void folderThatOthersCanRead_isRefused() throws Exception {
        Path open = Files.createDirectory(folder.resolve("lightning-ada"));
        Files.setPosixFilePermissions(open, PosixFilePermissions.fromString("rwxr-xr-x"));
        assertThatThrownBy(() -> ResidentPlace.in(null, folder, "ada")).isInstanceOf(IOException.class)
                .hasMessageContaining("expected a folder that only you can access, found rwxr-xr-x");
    }

    @Test
    void linkToAnotherFolder_isRefused() throws Exception {
        Path other = Files.createDirectory(folder.resolve("other"));
        Files.setPosixFilePermissions(other, PosixFilePermissions.fromString("rwx------"));
        Files.createSymbolicLink(folder.resolve("lightning-ada"), other);
        assertThatThrownBy(() -> ResidentPlace.in(null, folder, "ada")).isInstanceOf(IOException.class)
                .hasMessageContaining("expected a folder that only you can access");
    }
}
