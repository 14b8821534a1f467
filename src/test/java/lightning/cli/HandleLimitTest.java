package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import lightning.base.work.Await;
import lightning.cli.output.ExitCode;
import lightning.sample.Slow;
import lightning.sample.TestedProgram;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Processes with too few file handles. */
@EnabledOnOs({OS.LINUX, OS.MAC})
@Slow
final class HandleLimitTest {
    private static final int HANDLES = 40;

    @TempDir
    private Path folder;
    private Path certificate;

    @BeforeEach
    void makeCertificate() {
        certificate = folder.resolve("shared.p12");
        CliResult.run("node", "--make-certificate", certificate).assertSuccess();
    }

    private void check(String... words) throws Exception {
        List<String> line = new ArrayList<>(List.of("/bin/sh", "-c", "ulimit -n " + HANDLES + "; exec \"$@\"", "sh"));
        line.addAll(TestedProgram.command("-Xmx600m"));
        line.addAll(List.of(words));
        Path output = folder.resolve("said");
        Process process = new ProcessBuilder(line).redirectErrorStream(true).redirectOutput(output.toFile()).start();
        try {
            assertThat(process.waitFor(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)).as("the process ends").isTrue();
        } finally {
            process.destroyForcibly();
        }
        assertThat(Files.readString(output)).contains("too many files are open", "ulimit -n").doesNotContain("\tat ", "internal error");
        assertThat(process.exitValue()).isEqualTo(ExitCode.BAD_INPUT);
    }

    @Test
    void render_withoutFileHandles_isReported() throws Exception {
        check("render", "scenes/dusk.jen", "--size", "30x20", "-o", folder.resolve("a.png").toString());
    }

    @Test
    void relight_withoutFileHandles_isReported() throws Exception {
        check("shot", "relight", "scenes/dusk.jen", "--frames", "1-2", "--size", "30x20", "--set", "sky.on=no", "--cluster",
                "127.0.0.1:7800", "--certificate", certificate.toString(), "-o", folder.resolve("a").toString());
    }

    @Test
    void node_withoutFileHandles_isReported() throws Exception {
        check("node", "--certificate", certificate.toString(), "--port", "17802", "--folder", folder.toString());
    }
}
