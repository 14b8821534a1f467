package lightning.serve.resident;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.Channels;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import lightning.base.work.Await;
import lightning.base.work.DedicatedThread;
import lightning.serve.SocketListener;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@Timeout(value = Await.TIMEOUT_SECONDS, unit = TimeUnit.SECONDS)
@DisabledOnOs(OS.WINDOWS)
class ResidentServerTest {
    private static final Duration LONG = Duration.ofHours(1);

    @TempDir
    private Path folder;
    private final List<Thread> servers = new ArrayList<>();
    private final ByteArrayOutputStream out = new ByteArrayOutputStream();
    private final ByteArrayOutputStream err = new ByteArrayOutputStream();
    private int starts;

    @AfterEach
    void endServers() throws InterruptedException {
        for (Thread server : servers) {
            server.interrupt();
            server.join();
        }
    }

    private Path socket() {
        return folder.resolve("s");
    }

    /** Starts a server in this process. */
    private Thread serve(ResidentServer server, Duration idle) throws IOException {
        SocketListener listener = SocketListener.start(server, socket());
        Thread thread = DedicatedThread.create("server", () -> {
            try (listener) {
                server.awaitEnd(idle);
            } catch (IOException | InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        });
        thread.start();
        servers.add(thread);
        return thread;
    }

    private Thread serve(ResidentServer.CommandRunner runner) throws IOException {
        return serve(new ResidentServer(runner, Surroundings.ofThisProcess()), LONG);
    }

    private OptionalInt run(String... arguments) throws IOException {
        var client = new ResidentClient(socket(), () -> {
            starts++;
            throw new IOException("cannot start");
        });
        return client.run(new PrintStream(out, true, StandardCharsets.UTF_8), new PrintStream(err, true, StandardCharsets.UTF_8), false,
                List.of(arguments));
    }

    @Test
    void command_printsToBothStreamsAndReturnsItsCode() throws Exception {
        serve((o, e, _, arguments) -> {
            o.print("größe " + String.join("|", arguments));
            e.print("x".repeat(200_000));
            return 42;
        });
        assertThat(run("render", "", "ö 日")).hasValue(42);
        assertThat(out.toString(StandardCharsets.UTF_8)).isEqualTo("größe render||ö 日");
        assertThat(err.toString(StandardCharsets.UTF_8)).isEqualTo("x".repeat(200_000));
    }

    @Test
    void secondCommand_runsAfterTheFirstInOneProcess() throws Exception {
        int[] runs = new int[1];
        serve((_, _, _, _) -> ++runs[0]);
        assertThat(run()).hasValue(1);
        assertThat(run()).hasValue(2);
        assertThat(starts).isZero();
    }

    @Test
    void commandBesideAnother_isRefused() throws Exception {
        var began = new CountDownLatch(1);
        var end = new CountDownLatch(1);
        serve((_, _, _, _) -> {
            began.countDown();
            return awaitUnlessCanceled(end);
        });
        Thread first = DedicatedThread.create("first", () -> runQuietly());
        first.start();
        began.await();
        assertThat(run()).isEmpty();
        end.countDown();
        first.join();
    }

    private static int awaitUnlessCanceled(CountDownLatch end) {
        try {
            end.await();
            return 0;
        } catch (InterruptedException e) {
            return 130;
        }
    }

    private void runQuietly() {
        try {
            run();
        } catch (IOException | CancellationException e) {
            // It was canceled.
        }
    }

    @Test
    void interruptedClient_cancelsItsCommand() throws Exception {
        var began = new CountDownLatch(1);
        var canceled = new CountDownLatch(1);
        serve((_, _, _, _) -> {
            began.countDown();
            if (awaitUnlessCanceled(new CountDownLatch(1)) == 130) {
                canceled.countDown();
            }
            return 130;
        });
        Thread client = DedicatedThread.create("client", this::runQuietly);
        client.start();
        began.await();
        client.interrupt();
        canceled.await();
        client.join();
    }

    @Test
    void canceledCommand_leavesTheProcessToOthers() throws Exception {
        interruptedClient_cancelsItsCommand();
        assertThat(servers.getFirst().isAlive()).isTrue();
    }

    @Test
    void otherSurroundings_endTheProcess() throws Exception {
        Thread server = serve(new ResidentServer((_, _, _, _) -> 0, "those of another folder"), LONG);
        assertThatThrownBy(this::run).isInstanceOf(IOException.class).hasMessage("cannot start");
        server.join();
        assertThat(starts).isEqualTo(1);
        assertThat(socket()).doesNotExist();
    }

    @Test
    void idleProcess_ends() throws Exception {
        serve(new ResidentServer((_, _, _, _) -> 0, ""), Duration.ofMillis(1)).join();
        assertThat(socket()).doesNotExist();
    }

    @Test
    void stop_endsTheProcess() throws Exception {
        Thread server = serve((_, _, _, _) -> 0);
        assertThat(ResidentClient.stop(socket())).isTrue();
        server.join();
        assertThat(ResidentClient.stop(socket())).isFalse();
    }

    @Test
    void processThatEndsAtOnce_isStartedOnceMore() {
        var client = new ResidentClient(socket(), () -> {
            starts++;
            return new ProcessBuilder("true").start();
        });
        assertThatThrownBy(() -> client.run(System.out, System.err, false, List.of())).isInstanceOf(IOException.class)
                .hasMessage("it ends as soon as it was started");
        assertThat(starts).isEqualTo(2);
    }

    @Test
    void hostileRequest_isClosedAndTheNextOneServed() throws Exception {
        serve((_, _, _, _) -> 7);
        try (SocketChannel channel = SocketChannel.open(UnixDomainSocketAddress.of(socket()))) {
            var to = new DataOutputStream(Channels.newOutputStream(channel));
            to.writeUTF(Surroundings.ofThisProcess());
            to.writeBoolean(false);
            to.writeBoolean(false);
            to.writeUTF("UTF-8");
            to.writeInt(Integer.MAX_VALUE);
            to.writeInt(Integer.MAX_VALUE);
            assertThat(Channels.newInputStream(channel).read()).isEqualTo(-1);
        }
        assertThat(run()).hasValue(7);
    }

    @Test
    void unknownCharset_leavesTheProcessToOthers() throws Exception {
        serve((_, _, _, _) -> 7);
        try (SocketChannel channel = SocketChannel.open(UnixDomainSocketAddress.of(socket()))) {
            new ResidentRequest(Surroundings.ofThisProcess(), false, false, "no such charset", List.of())
                    .write(new DataOutputStream(Channels.newOutputStream(channel)));
            assertThat(Channels.newInputStream(channel).read()).isEqualTo(-1);
        }
        assertThat(run()).hasValue(7);
    }
}
