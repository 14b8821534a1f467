package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import lightning.base.work.Await;
import lightning.sample.Slow;
import lightning.sample.TestedProgram;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Processes of commands with {@code --resident}. */
@DisabledOnOs(OS.WINDOWS)
@Slow
class ResidentRunTest {
    /** Its path must fit into the address of a socket. */
    @TempDir
    private Path folder;
    private Path scene;

    @BeforeEach
    void writeScene() throws IOException {
        scene = CliResult.scene(folder);
    }

    @AfterEach
    void stop() throws Exception {
        run("resident", "--stop");
    }

    private ProcessBuilder command(String... arguments) {
        List<String> line = TestedProgram.command("-Xmx400m");
        line.addAll(List.of(arguments));
        var builder = new ProcessBuilder(line).directory(folder.toFile());
        builder.environment().put("XDG_RUNTIME_DIR", folder.toString());
        return builder;
    }

    private CliResult run(String... arguments) throws Exception {
        Path out = folder.resolve("out.txt");
        Path err = folder.resolve("err.txt");
        Process process = command(arguments).redirectOutput(out.toFile()).redirectError(err.toFile()).start();
        assertThat(process.waitFor(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)).isTrue();
        return new CliResult(process.exitValue(), Files.readString(out), Files.readString(err));
    }

    @Test
    void secondRender_updatesThePictureOfTheFirst() throws Exception {
        run("render", "a.jen", "-o", "own.png").assertSuccess();
        assertThat(run("render", "a.jen", "-o", "first.png", "--resident").assertSuccess().out()).contains("first.png: first pass");
        assertThat(run("render", "a.jen", "-o", "second.png", "--resident").assertSuccess().out())
                .contains("second.png: update of 48 x 32 pixels", ": 0 eye rays");
        assertThat(folder.resolve("first.png")).hasSameBinaryContentAs(folder.resolve("own.png"));
        assertThat(folder.resolve("second.png")).hasSameBinaryContentAs(folder.resolve("own.png"));
    }

    @Test
    void editedScene_hasTheBytesOfAProcessOfItsOwn() throws Exception {
        run("render", "a.jen", "-o", "first.exr", "--layers", "--resident").assertSuccess();
        Files.writeString(scene, CliResult.SCENE.replace("at -3 4 3", "at -1 2 3").replace("ambience 0.5", "ambience 0.25"));
        assertThat(run("render", "a.jen", "-o", "second.exr", "--layers", "--resident").assertSuccess().out()).contains("update of");
        run("render", "a.jen", "-o", "own.exr", "--layers").assertSuccess();
        assertThat(folder.resolve("second.exr")).hasSameBinaryContentAs(folder.resolve("own.exr"));
    }

    @Test
    void mistake_isReportedAsByAProcessOfItsOwn() throws Exception {
        CliResult own = run("render", "missing.jen", "-o", "a.png");
        assertThat(run("render", "missing.jen", "-o", "a.png", "--resident")).isEqualTo(own);
        assertThat(own.exit()).isEqualTo(2);
    }

    @Test
    void killedResidentProcess_isReplaced() throws Exception {
        run("render", "a.jen", "-o", "first.png", "--resident").assertSuccess();
        Path socket = folder.resolve("lightning/resident");
        assertThat(socket).exists();
        ProcessHandle.allProcesses().filter(this::isResident).forEach(ProcessHandle::destroyForcibly);
        assertThat(run("render", "a.jen", "-o", "second.png", "--resident").assertSuccess().out()).contains("second.png: first pass");
    }

    /** Only those of this test have its folder as the working folder. */
    private boolean isResident(ProcessHandle process) {
        Path own = Path.of("/proc", String.valueOf(process.pid()));
        try {
            return Files.readString(own.resolve("cmdline"), StandardCharsets.ISO_8859_1).endsWith("\0resident\0")
                    && own.resolve("cwd").toRealPath().equals(folder.toRealPath());
        } catch (IOException e) {
            return false;
        }
    }

    @Test
    void unusableRuntimeFolder_rendersInItsOwnProcess() throws Exception {
        Files.writeString(folder.resolve("lightning"), "a file");
        CliResult result = run("render", "a.jen", "-o", "a.png", "--resident").assertSuccess();
        assertThat(result.out()).contains("a.png: first pass");
        assertThat(result.err()).contains("lightning: without the resident process: ");
        Files.delete(folder.resolve("lightning"));
    }
}
