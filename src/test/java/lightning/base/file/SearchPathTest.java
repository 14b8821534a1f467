package lightning.base.file;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Search of programs. */
class SearchPathTest {
    @TempDir
    Path folder;

    private Path program(Path parent, String name) throws IOException {
        Path program = Files.writeString(parent.resolve(name), "#!/bin/sh\n");
        return Files.setPosixFilePermissions(program, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    @Test
    void firstExecutableFile_isFound() throws IOException {
        Path first = Files.createDirectory(folder.resolve("first"));
        Path second = Files.createDirectory(folder.resolve("second"));
        Files.writeString(first.resolve("cc"), "no program");
        Files.createDirectory(first.resolve("povray"));
        Path compiler = program(second, "cc");
        Path povray = program(second, "povray");
        SearchPath path = SearchPath.of(String.join(File.pathSeparator, "/nowhere", "\0", first.toString(), "", second.toString()));
        assertThat(path.find("cc")).contains(compiler);
        assertThat(path.find("povray")).contains(povray);
        assertThat(path.find("ffmpeg")).isEmpty();
        assertThat(path.find("\0")).isEmpty();
    }

    @Test
    void windowsName_isFound() throws IOException {
        assertThat(SearchPath.of(program(folder, "ffmpeg.exe").getParent().toString()).find("ffmpeg"))
                .contains(folder.resolve("ffmpeg.exe"));
    }

    @Test
    void variableThatIsNotSet_hasNoFolders() {
        assertThat(SearchPath.of(null).folders()).isEmpty();
        assertThat(SearchPath.of("").folders()).isEmpty();
    }
}
