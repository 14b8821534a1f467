package lightning.base.process;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import lightning.base.file.SearchPath;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@DisabledOnOs(OS.WINDOWS)
class PythonInterpreterTest {
    private static final PythonPackage USD = new PythonPackage("usd-core", "USD files");
    @TempDir
    private Path folder;

    @Test
    void interpreter_isChosenOrFoundOrAskedFor() throws Exception {
        Path python =
                Files.setPosixFilePermissions(Files.createFile(folder.resolve("python3")), PosixFilePermissions.fromString("rwxr-xr-x"));
        SearchPath path = SearchPath.of(folder.toString());
        assertThat(PythonInterpreter.find(null, path, USD)).isEqualTo(python);
        assertThat(PythonInterpreter.find("", path, USD)).isEqualTo(python);
        assertThat(PythonInterpreter.find(python.toString(), SearchPath.of(null), USD)).isEqualTo(python);
        assertThat(PythonInterpreter.find("python3", path, USD)).isEqualTo(python);
        assertThatThrownBy(() -> PythonInterpreter.find(null, SearchPath.of(null), USD)).isInstanceOf(IOException.class)
                .hasMessage("USD files need Python with the package usd-core; install Python 3, then run: pip install usd-core");
        assertThatThrownBy(() -> PythonInterpreter.find("/nowhere/python", path, USD)).isInstanceOf(IOException.class)
                .hasMessage("LIGHTNING_PYTHON names '/nowhere/python', which is not a program");
    }
}
