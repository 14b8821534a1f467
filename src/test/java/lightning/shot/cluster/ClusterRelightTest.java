package lightning.shot.cluster;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import lightning.base.work.Await;
import lightning.sample.Slow;
import lightning.sample.TestedProgram;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Runs the command as a process, with nodes as processes. */
@Slow
final class ClusterRelightTest {
    private static final int TIMEOUT_SECONDS = 240;
    /** Time in which a process looks for a first node, long enough for two attempts. */
    private static final int WAIT_SECONDS = 12;

    @TempDir
    private Path folder;

    /** The program in its own process. */
    private final class CommandProcess implements AutoCloseable {
        private final Path output = Files.createTempFile(folder, "output", "");
        private final Process process;

        CommandProcess(String... words) throws IOException {
            List<String> line = TestedProgram.command("-Xmx600m", "-Dlightning.cluster.wait=" + WAIT_SECONDS);
            line.addAll(List.of(words));
            process = new ProcessBuilder(line).redirectErrorStream(true).redirectOutput(output.toFile()).start();
        }

        /** Waits until it ends with an exit code; returns its output. */
        String end(int exit) throws Exception {
            assertThat(process.waitFor(TIMEOUT_SECONDS, TimeUnit.SECONDS)).as(Files.readString(output)).isTrue();
            assertThat(process.exitValue()).as(Files.readString(output)).isEqualTo(exit);
            return Files.readString(output);
        }

        @Override
        public void close() {
            process.destroyForcibly();
        }
    }

    private String run(int exit, String... words) throws Exception {
        try (CommandProcess run = new CommandProcess(words)) {
            return run.end(exit);
        }
    }

    @Test
    void clusterPictures_matchLocalOnes_andForeignCertificatesAreRejected() throws Exception {
        String certificate = folder.resolve("shared.p12").toString();
        assertThat(run(0, "node", "--make-certificate", certificate)).contains("created; copy it to each machine");
        int port = FreePort.next();
        String[] words = {"shot", "relight", "scenes/dusk.jen", "--frames", "1-4", "--size", "60x40", "--set", "sky.on=no", "--then",
            "--set", "world.ambience=0.3"};
        try (var _ = new NodeProcess(port, List.of(port), folder)) {
            // The command waits only so long for a node, which should not include the start of Java.
            Await.until("the node has started",
                    () -> Files.readString(folder.resolve("node-" + port + ".log")).contains("node running at"));
            String other = folder.resolve("other.p12").toString();
            SelfSignedCertificate.write(Path.of(other));
            // Tries without success, while the others work.
            try (CommandProcess stranger = new CommandProcess(
                    with(words, "-o", folder.resolve("none").toString(), "--cluster", "127.0.0.1:" + port, "--certificate", other))) {
                String output = run(0, with(words, "-o", folder.resolve("elsewhere").toString(), "--cluster", "127.0.0.1:" + port,
                        "--certificate", certificate));
                assertThat(output).contains("4 frames traced by 1 node", "2. 4 frames relit by 1 node", "0 of them retraced");
                run(0, with(words, "-o", folder.resolve("here").toString()));
                for (String file : List.of("1/dusk-0001.png", "1/dusk-0004.png", "2/dusk-0003.png")) {
                    assertThat(folder.resolve("elsewhere").resolve(file)).hasSameBinaryContentAs(folder.resolve("here").resolve(file));
                }
                assertThat(stranger.end(2)).contains("no node answers at 127.0.0.1:" + port + ":").contains("another certificate")
                        .doesNotContain("Exception");
            }
        }
    }

    private static String[] with(String[] words, String... more) {
        List<String> arguments = new ArrayList<>(List.of(words));
        arguments.addAll(List.of(more));
        return arguments.toArray(String[]::new);
    }
}
