package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import lightning.base.file.AtomicFile;
import lightning.base.work.Await;
import lightning.base.work.Progress;
import lightning.cli.output.Console;
import lightning.cli.output.ErrorReporter;
import lightning.cli.output.ProgressBar;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Termination of the whole process from outside, as by Ctrl-C. */
@DisabledOnOs(OS.WINDOWS)
@Slow
class InterruptTest {
    private static final int EDITS = 1000;

    @TempDir
    Path folder;

    @Test
    void interruptedTrace_isReportedAndLeavesNoFile() throws Exception {
        Path scene = CliResult.scene(folder);
        List<String> line = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "--add-modules", "jdk.incubator.vector", "-cp", System.getProperty("java.class.path"), "lightning.Main",
                "relight", scene.toString(), "-o", folder.resolve("a.png").toString(), "--size", "200x200"));
        for (int edit = 0; edit < EDITS; edit++) {
            line.addAll(List.of("--set", "sun.intensity=" + edit, "--then"));
        }
        Process process = new ProcessBuilder(line).redirectErrorStream(true).start();
        try (var out = new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8))) {
            // The first pass is done; the many edits keep the process busy.
            assertThat(out.lines().anyMatch(text -> text.startsWith("first pass"))).isTrue();
            // Process.destroy would also close the streams.
            process.toHandle().destroy();
            assertThat(out.lines().toList()).contains("lightning: canceled");
        }
        assertThat(process.waitFor(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)).isTrue();
        assertThat(process.exitValue()).isEqualTo(143);
        try (var files = Files.list(folder)) {
            assertThat(files.toList()).isEqualTo(List.of(scene));
        }
    }

    @Test
    void interruptedSave_leavesOnlyTheOldFile() throws Exception {
        Path file = Files.writeString(folder.resolve("a.png"), "old");
        int[] exit = new int[1];
        var err = new ByteArrayOutputStream();
        Thread command = new Thread(() -> {
            try {
                AtomicFile.write(file, out -> {
                    Thread.currentThread().interrupt();
                    out.write(new byte[1_000_000]);
                });
            } catch (IOException e) {
                var print = new PrintStream(err, true, StandardCharsets.UTF_8);
                exit[0] = ErrorReporter.report(new Console(print, print, false), e);
            }
        });
        command.start();
        command.join();
        assertThat(exit[0]).isEqualTo(130);
        assertThat(file).hasContent("old");
        try (var files = Files.list(folder)) {
            assertThat(files.toList()).containsExactly(file);
        }
    }

    @Test
    void progressBar_interruptedThread_cancels() {
        try (var bar = new ProgressBar(new Console(System.out, System.err, false), "work")) {
            Progress silent = bar.cancellationOnly();
            assertThat(bar.isCanceled()).isFalse();
            Thread.currentThread().interrupt();
            assertThat(bar.isCanceled()).isTrue();
            assertThat(silent.isCanceled()).isTrue();
        } finally {
            assertThat(Thread.interrupted()).isTrue();
        }
    }
}
