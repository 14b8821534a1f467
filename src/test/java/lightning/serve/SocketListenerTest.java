package lightning.serve;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.channels.ServerSocketChannel;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import lightning.base.work.Await;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@Timeout(value = Await.TIMEOUT_SECONDS, unit = TimeUnit.SECONDS)
@DisabledOnOs(OS.WINDOWS)
class SocketListenerTest {
    private static final byte[] LIST = "{\"id\":1,\"method\":\"list\"}\n".getBytes(StandardCharsets.US_ASCII);

    @TempDir
    private Path folder;
    private final Server server = new Server(new ServerOptions(1, 100_000_000));

    @AfterEach
    void end() {
        server.close();
    }

    private static SocketChannel open(Path path) throws IOException {
        return SocketChannel.open(UnixDomainSocketAddress.of(path));
    }

    private static String ask(SocketChannel channel) throws IOException {
        channel.write(ByteBuffer.wrap(LIST));
        return new BufferedReader(new InputStreamReader(Channels.newInputStream(channel), StandardCharsets.UTF_8)).readLine();
    }

    private List<Path> files() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.toList();
        }
    }

    @Test
    void socket_isOpenToItsUserOnly_andRemovedAtTheEnd() throws IOException {
        Path path = folder.resolve("s.sock");
        try (SocketListener _ = SocketListener.start(server, path); SocketChannel first = open(path); SocketChannel second = open(path)) {
            assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(path))).isEqualTo("rw-------");
            assertThat(ask(second)).startsWith("{\"id\":1,\"result\":");
            assertThat(ask(first)).contains("\"protocol\":1");
            assertThat(files()).containsExactly(path);
        }
        assertThat(files()).isEmpty();
    }

    @Test
    void secondServer_isRefused() throws IOException {
        Path path = folder.resolve("s.sock");
        try (SocketListener _ = SocketListener.start(server, path)) {
            assertThatThrownBy(() -> SocketListener.start(server, path)).isInstanceOf(IOException.class)
                    .hasMessageEndingWith("s.sock: another server uses this socket");
            try (SocketChannel client = open(path)) {
                assertThat(ask(client)).contains("result");
            }
        }
    }

    @Test
    void socketOfAnEndedServer_isReplaced() throws IOException {
        Path path = folder.resolve("s.sock");
        try (ServerSocketChannel killed = ServerSocketChannel.open(StandardProtocolFamily.UNIX)) {
            killed.bind(UnixDomainSocketAddress.of(path));
        }
        assertThat(path).exists();
        try (SocketListener _ = SocketListener.start(server, path); SocketChannel client = open(path)) {
            assertThat(ask(client)).contains("result");
        }
    }

    @Test
    void otherFile_isKept() throws IOException {
        Path file = Files.writeString(folder.resolve("letter.txt"), "Dear reader");
        assertThatThrownBy(() -> SocketListener.start(server, file)).isInstanceOf(IOException.class)
                .hasMessageContaining("letter.txt: exists already and is not a socket");
        assertThat(file).hasContent("Dear reader");
        assertThatThrownBy(() -> SocketListener.start(server, folder)).hasMessageContaining("is not a socket");
        assertThat(files()).containsExactly(file);
    }

    @Test
    void impossiblePath_isRefused() throws IOException {
        assertThatThrownBy(() -> SocketListener.start(server, folder.resolve("x".repeat(200)))).isInstanceOf(IOException.class)
                .hasMessageContaining("may have at most");
        assertThatThrownBy(() -> SocketListener.start(server, folder.resolve("none").resolve("s"))).isInstanceOf(IOException.class)
                .hasMessageContaining("folder not found");
        assertThat(files()).isEmpty();
    }

    @Test
    void clientsBeyondTheLimit_areClosed() throws IOException {
        Path path = folder.resolve("s.sock");
        List<SocketChannel> clients = new ArrayList<>();
        try (SocketListener _ = SocketListener.start(server, path)) {
            for (int i = 0; i < SocketListener.MAX_CLIENTS; i++) {
                clients.add(open(path));
                assertThat(ask(clients.getLast())).contains("result");
            }
            try (SocketChannel more = open(path)) {
                assertThat(more.read(ByteBuffer.allocate(1))).isEqualTo(-1);
            }
            clients.removeFirst().close();
            while (server.clientCount() == SocketListener.MAX_CLIENTS) {
                Thread.onSpinWait();
            }
            try (SocketChannel more = open(path)) {
                assertThat(ask(more)).contains("result");
            }
        } finally {
            for (SocketChannel client : clients) {
                client.close();
            }
        }
    }
}
