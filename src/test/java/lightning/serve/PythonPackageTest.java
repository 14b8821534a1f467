package lightning.serve;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.format.jen.JenReader;
import lightning.format.jen.PropertyEdit;
import lightning.sample.PythonPrograms;
import lightning.sample.Slow;
import lightning.sample.TestedProgram;
import lightning.scene.Scene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** The package for Python, used by real Python. */
@Slow
@DisabledOnOs(OS.WINDOWS)
class PythonPackageTest {
    private static final Path PACKAGE = Path.of("src/main/python").toAbsolutePath();

    @TempDir
    private Path folder;

    private Path trace(Scene scene, String name) throws IOException {
        float[] rgb = ServerTest.trace(scene).toScanlines();
        ByteBuffer bytes = ByteBuffer.allocate(rgb.length * Float.BYTES).order(ByteOrder.LITTLE_ENDIAN);
        bytes.asFloatBuffer().put(rgb);
        return Files.write(folder.resolve(name), bytes.array());
    }

    @Test
    void functions_answerAsDocumented() throws Exception {
        PythonPrograms.require("numpy");
        Path file = Files.writeString(folder.resolve("scene.jen"), ServerTest.SCENE);
        Scene scene = JenReader.read(file).scene();
        Scene edited = PropertyEdit.apply(PropertyEdit.apply(scene, "key.color=1 0.5 0"), "fill.intensity=0.7");
        String text = PythonPrograms.output(folder, List.of("-B", Path.of("src/test/python/relight_client.py").toAbsolutePath().toString(),
                PACKAGE.toString(), JsonLines.JSON.writeValueAsString(TestedProgram.command("-Xmx600m")), file.toString(),
                trace(scene, "plain").toString(),
                trace(edited, "edited").toString()));
        assertThat(text).endsWith("done\n");
    }

    /** The newest Python is not needed, and no other package. */
    @Test
    void package_importsStandardLibraryOnly() throws IOException {
        PythonPrograms.require("json");
        assertThat(PythonPrograms.output(folder, List.of("-B", "-S", "-c",
                "import sys; sys.path.insert(0, '" + PACKAGE + "'); import lightning_relight; print('numpy' in sys.modules)")))
                .isEqualTo("False\n");
    }

    @Test
    void package_isInstalledByPip() throws IOException {
        PythonPrograms.require("pip", "setuptools", "wheel");
        // pip writes next to the sources that it builds.
        Path copy = Files.createDirectory(folder.resolve("sources"));
        Files.copy(PACKAGE.resolve("pyproject.toml"), copy.resolve("pyproject.toml"));
        for (String name : List.of("lightning_relight", "lightning_openjd")) {
            Path modules = Files.createDirectory(copy.resolve(name));
            try (var files = Files.list(PACKAGE.resolve(name))) {
                for (Path file : files.filter(Files::isRegularFile).toList()) {
                    Files.copy(file, modules.resolve(file.getFileName()));
                }
            }
        }
        PythonPrograms.output(folder, List.of("-m", "pip", "install", "-q", "--no-index", "--no-deps", "--no-build-isolation",
                "--disable-pip-version-check", "--target", folder.resolve("installed").toString(), copy.toString()));
        assertThat(folder.resolve("installed/lightning_relight/client.py")).exists();
        assertThat(folder.resolve("installed/lightning_relight/py.typed")).exists();
        assertThat(folder.resolve("installed/lightning_openjd/ShotAdaptor.json")).exists();
    }

    @Test
    void notebook_runs() throws IOException {
        PythonPrograms.require("numpy", "nbclient", "ipykernel");
        String text = PythonPrograms.output(folder, List.of("-B", Path.of("src/test/python/run_notebook.py").toAbsolutePath().toString(),
                PACKAGE.toString(), JsonLines.JSON.writeValueAsString(notebookProgram()),
                PACKAGE.resolve("notebooks/edit_loop.ipynb").toString()));
        assertThat(text).contains("gives a mean of 0.150", "of feet", "after them: 0.150");
    }

    /** Returns the command with the program's folder, whose scenes the notebook opens. */
    private static List<String> notebookProgram() {
        List<String> command = TestedProgram.command("-Xmx600m");
        command.add(1, "-Dlightning.home=" + Path.of("").toAbsolutePath());
        return command;
    }
}
