package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Outputs that cannot be written, and inputs that are no ordinary files. */
@DisabledOnOs(OS.WINDOWS)
class OddFilesTest {
    @TempDir
    private Path folder;

    @Test
    void resultsThatCannotBeWritten_areAComplaintWithExitCode2() throws IOException {
        var full = new PrintStream(new OutputStream() {
            @Override
            public void write(int b) throws IOException {
                throw new IOException("No space left on device");
            }
        }, false, StandardCharsets.UTF_8);
        var err = new ByteArrayOutputStream();
        int exit = Lightning.run(full, new PrintStream(err, true, StandardCharsets.UTF_8), "check", Cli.scene(folder).toString());
        assertThat(exit).isEqualTo(2);
        assertThat(err.toString(StandardCharsets.UTF_8)).hasLineCount(1).contains("could not be written to the standard output");
    }

    @Test
    void pipeAsScene_isRefusedAtOnce() throws Exception {
        Path pipe = folder.resolve("pipe.jen");
        assertThat(new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor()).isZero();
        Cli.run("check", pipe).isRefusedSaying("pipe.jen: is no file but a pipe or a device");
    }

    @Test
    void deviceAsScene_isRefusedAtOnce() {
        Cli.run("check", "/dev/zero").isRefusedSaying("/dev/zero: is no file but a pipe or a device");
    }

    @Test
    void deviceAsBaseline_isRefusedBeforeAnythingIsMeasured() throws IOException {
        Cli.run("bench", Cli.scene(folder), "-o", folder.resolve("out"), "--baseline", "/dev/zero")
                .isRefusedSaying("/dev/zero: is no file, expected results of 'lightning bench'");
    }

    @Test
    void baselineWithoutALevel_isRefusedBeforeAnythingIsMeasured() throws IOException {
        String known = Files.readString(Path.of("benchmarks/results/results.json"));
        String level = "\"level\" : \"";
        int at = known.indexOf(level);
        assertThat(at).isPositive();
        String broken = known.substring(0, at) + "\"level\" : null" + known.substring(known.indexOf('"', at + level.length()) + 1);
        Path file = Files.writeString(folder.resolve("old.json"), broken);
        Cli.run("bench", Cli.scene(folder), "-o", folder.resolve("out"), "--baseline", file)
                .isRefusedSaying("old.json", "no results of 'lightning bench'", "a level is missing");
    }

    @Test
    void nameThatCannotBeAFiles_isRefusedInASentence() {
        Cli.run("check", "a\0b.jen").isRefusedSaying("cannot be a file's name here", "LC_ALL=C.UTF-8");
    }
}
