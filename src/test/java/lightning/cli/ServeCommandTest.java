package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import lightning.base.work.Await;
import lightning.sample.Slow;
import lightning.sample.TestedProgram;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Processes of {@code lightning serve}. */
@DisabledOnOs(OS.WINDOWS)
@Slow
class ServeCommandTest {
    @TempDir
    private Path folder;

    private Process start(String... options) throws IOException {
        List<String> line = TestedProgram.command("-Xmx400m");
        line.add("serve");
        line.addAll(List.of(options));
        return new ProcessBuilder(line).redirectError(folder.resolve("errors").toFile()).start();
    }

    private static String ask(BufferedWriter to, BufferedReader from, String request) throws IOException {
        to.write(request.replace('\'', '"') + "\n");
        to.flush();
        return from.readLine();
    }

    private static int exit(Process process) throws InterruptedException {
        assertThat(process.waitFor(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)).as("the process ends").isTrue();
        return process.exitValue();
    }

    @Test
    void standardStreams_answerAndEnd() throws Exception {
        Process process = start("--threads", "1");
        Path shared;
        try (BufferedWriter to = process.outputWriter(); BufferedReader from = process.inputReader()) {
            assertThat(ask(to, from, "{'id':1,'method':'open','file':'scenes/bird.jen'}")).contains("\"scene\":1");
            assertThat(ask(to, from, "{'id':2,'method':'set','scene':1,'edits':'picture.size=40 30'}")).contains("\"steps\":1");
            String rendered = ask(to, from, "{'id':3,'method':'render','scene':1,'memory':true}");
            shared = Path.of(rendered.replaceAll(".*\"path\":\"([^\"]*)\".*", "$1"));
            assertThat(shared).exists();
            to.close();
            assertThat(from.readLine()).isNull();
        }
        assertThat(exit(process)).isZero();
        assertThat(shared).doesNotExist();
        assertThat(shared.getParent()).doesNotExist();
    }

    @Test
    void shutdown_endsTheProcess() throws Exception {
        Process process = start("--threads", "1");
        try (BufferedWriter to = process.outputWriter(); BufferedReader from = process.inputReader()) {
            assertThat(ask(to, from, "{'id':'bye','method':'shutdown'}")).isEqualTo("{\"id\":\"bye\",\"result\":{}}");
            assertThat(exit(process)).isZero();
        }
    }

    /** A long render is canceled, and neither the socket nor shared memory is left. */
    @Test
    void termination_leavesNoFile() throws Exception {
        Path socket = folder.resolve("s.sock");
        Process process = start("--socket", socket.toString(), "--threads", "1");
        try (BufferedReader from = process.inputReader()) {
            assertThat(from.readLine()).contains("s.sock: waiting for clients");
            try (var channel = SocketChannel.open(UnixDomainSocketAddress.of(socket));
                    var answers = new BufferedReader(new InputStreamReader(Channels.newInputStream(channel), StandardCharsets.UTF_8))) {
                channel.write(ByteBuffer.wrap("""
                        {"id":1,"method":"open","file":"scenes/balls.jen"}
                        {"id":2,"method":"set","scene":1,"edits":["picture.size=20 20","picture.antialias=off"]}
                        {"id":3,"method":"render","scene":1,"memory":true}
                        {"id":4,"method":"set","scene":1,"edits":"picture.size=1500 1000"}
                        {"id":5,"method":"render","scene":1,"progress":true}
                        """.getBytes(StandardCharsets.UTF_8)));
                String line = answers.readLine();
                String path = "";
                while (!line.contains("progress")) {
                    path = line.contains("\"path\"") ? line.replaceAll(".*\"path\":\"([^\"]*)\".*", "$1") : path;
                    line = answers.readLine();
                }
                assertThat(Path.of(path)).exists();
                process.toHandle().destroy();
                assertThat(answers.lines().toList().getLast()).contains("\"id\":5", "canceled");
                assertThat(exit(process)).isEqualTo(143);
                assertThat(Path.of(path).getParent()).doesNotExist();
            }
        }
        assertThat(Files.readString(folder.resolve("errors"))).endsWith("lightning: canceled\n");
        try (Stream<Path> files = Files.list(folder)) {
            assertThat(files).containsExactly(folder.resolve("errors"));
        }
    }

    /** A client that is killed while its picture is traced. */
    @Test
    void clientThatIsGone_endsTheProcess() throws Exception {
        Process process = start("--threads", "1");
        try (BufferedWriter to = process.outputWriter(); BufferedReader from = process.inputReader()) {
            assertThat(ask(to, from, "{'id':1,'method':'open','file':'scenes/hall.jen'}")).contains("\"scene\":1");
            ask(to, from, "{'id':2,'method':'set','scene':1,'edits':['picture.size=2500 2500','picture.indirect=none']}");
            to.write("{\"id\":3,\"method\":\"render\",\"scene\":1}\n");
        }
        assertThat(exit(process)).isEqualTo(2);
        assertThat(Files.readAllLines(folder.resolve("errors"))).allMatch(line -> line.startsWith("WARNING: Using incubator modules"));
    }

    @Test
    void badOptions_areRejected() throws IOException {
        CliResult.run("serve", "--memory", "0").assertRejected("--memory must be more than 0");
        assertThat(CliResult.run("serve", "--json").out()).contains("serve does not take --json");
        Path file = Files.writeString(folder.resolve("a.txt"), "");
        CliResult.run("serve", "--socket", file).assertRejected("a.txt: exists already and is not a socket");
    }
}
