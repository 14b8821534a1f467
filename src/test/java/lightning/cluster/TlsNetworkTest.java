package lightning.cluster;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import javax.net.ssl.SSLException;
import javax.net.ssl.SSLSocket;
import org.jgroups.BytesMessage;
import org.jgroups.Message;
import org.jgroups.MessageFactory;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class TlsNetworkTest {
    private static final int PATIENCE_SECONDS = 60;
    private static final Place.Timing QUICK = new Place.Timing(8000, 1000, 1500);

    @TempDir
    static Path folder;
    private static Path certificate;
    private static Path other;

    @BeforeAll
    static void makeCertificates() throws IOException {
        certificate = folder.resolve("shared.p12");
        other = folder.resolve("other.p12");
        SelfSigned.write(certificate);
        SelfSigned.write(other);
    }

    /** What a member heard. */
    private static final class Heard implements Network.Listener {
        final BlockingQueue<byte[]> messages = new LinkedBlockingQueue<>();
        final BlockingQueue<Set<Member>> views = new LinkedBlockingQueue<>();

        @Override
        public void heard(Member from, byte[] bytes) {
            messages.add(bytes);
        }

        @Override
        public void changed(Set<Member> others) {
            views.add(others);
        }

        Set<Member> awaitOthers(int count) throws InterruptedException {
            for (Set<Member> view = next();; view = next()) {
                if (view.size() == count) {
                    return view;
                }
            }
        }

        private Set<Member> next() throws InterruptedException {
            Set<Member> view = views.poll(PATIENCE_SECONDS, TimeUnit.SECONDS);
            assertThat(view).as("a change of members").isNotNull();
            return view;
        }
    }

    static int freePort() throws IOException {
        try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            return socket.getLocalPort();
        }
    }

    private static Place place(int port, int join, Path certificate) {
        InetAddress here = InetAddress.getLoopbackAddress();
        return new Place(here, port, 1, List.of(new InetSocketAddress(here, join)), certificate, QUICK);
    }

    @Test
    void membersOfOneCertificate_hearEachOther() throws Exception {
        int first = freePort();
        int second = freePort();
        var a = new Heard();
        var b = new Heard();
        try (var one = new TlsNetwork(place(first, first, certificate)); var two = new TlsNetwork(place(second, first, certificate))) {
            one.join(a);
            two.join(b);
            Member to = a.awaitOthers(1).iterator().next();
            byte[] large = new byte[1 << 20];
            large[5] = 7;
            one.send(to, large);
            assertThat(b.messages.poll(PATIENCE_SECONDS, TimeUnit.SECONDS)).isEqualTo(large);
            assertThat(one.name(to)).isEqualTo("127.0.0.1:" + second);
        }
    }

    @Test
    void strangerWithAnotherCertificate_staysAlone() throws Exception {
        int first = freePort();
        var a = new Heard();
        var stranger = new Heard();
        try (var one = new TlsNetwork(place(first, first, certificate)); var two = new TlsNetwork(place(freePort(), first, other))) {
            one.join(a);
            two.join(stranger);
            // Long enough for parts of a cluster to find each other.
            Thread.sleep(2 * QUICK.merge());
            assertThat(a.views).allMatch(Set::isEmpty);
            assertThat(stranger.views).isNotEmpty().allMatch(Set::isEmpty);
        }
    }

    @Test
    void strangerWithoutACertificate_isRefused() throws Exception {
        int port = freePort();
        try (var one = new TlsNetwork(place(port, port, certificate))) {
            one.join(new Heard());
            // It trusts whomever it meets, but has nothing to show.
            var context = javax.net.ssl.SSLContext.getInstance("TLSv1.3");
            context.init(null, new javax.net.ssl.TrustManager[] {new TrustsAll()}, null);
            try (SSLSocket socket = (SSLSocket) context.getSocketFactory().createSocket(InetAddress.getLoopbackAddress(), port)) {
                socket.setSoTimeout(PATIENCE_SECONDS * 1000);
                assertThatThrownBy(() -> {
                    socket.startHandshake();
                    // With TLS 1.3 the refusal comes behind the client's own end of the handshake; who was let in hears nothing.
                    socket.getInputStream().read();
                }).isInstanceOf(SSLException.class).hasMessageContaining("certificate");
            }
            try (Socket plain = new Socket(InetAddress.getLoopbackAddress(), port)) {
                plain.setSoTimeout(PATIENCE_SECONDS * 1000);
                plain.getOutputStream().write(new byte[100]);
                InputStream in = plain.getInputStream();
                // An alert of TLS, then the end.
                assertThat(in.readAllBytes().length).isLessThan(100);
            }
        }
    }

    private static final class TrustsAll extends javax.net.ssl.X509ExtendedTrustManager {
        @Override
        public void checkClientTrusted(java.security.cert.X509Certificate[] chain, String type, Socket socket) {}

        @Override
        public void checkServerTrusted(java.security.cert.X509Certificate[] chain, String type, Socket socket) {}

        @Override
        public void checkClientTrusted(java.security.cert.X509Certificate[] chain, String type, javax.net.ssl.SSLEngine engine) {}

        @Override
        public void checkServerTrusted(java.security.cert.X509Certificate[] chain, String type, javax.net.ssl.SSLEngine engine) {}

        @Override
        public void checkClientTrusted(java.security.cert.X509Certificate[] chain, String type) {}

        @Override
        public void checkServerTrusted(java.security.cert.X509Certificate[] chain, String type) {}

        @Override
        public java.security.cert.X509Certificate[] getAcceptedIssuers() {
            return new java.security.cert.X509Certificate[0];
        }
    }

    @Test
    void messagesThatNameClasses_areNeverRead() throws Exception {
        int port = freePort();
        try (var one = new TlsNetwork(place(port, port, certificate))) {
            one.join(new Heard());
            for (short type : new short[] {Message.OBJ_MSG, Message.LONG_MSG, Message.NIO_MSG, Message.COMPOSITE_MSG, Message.FRAG_MSG,
                Message.EARLYBATCH_MSG}) {
                assertThatThrownBy(() -> MessageFactory.create(type)).isInstanceOf(IllegalArgumentException.class);
            }
            assertThat((Message) MessageFactory.create(Message.BYTES_MSG)).isInstanceOf(BytesMessage.class);
        }
    }

    @Test
    void certificate_isItsOwnersAlone() throws IOException {
        assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(certificate))).isEqualTo("rw-------");
        byte[] before = Files.readAllBytes(certificate);
        assertThatThrownBy(() -> SelfSigned.write(certificate)).isInstanceOf(IOException.class);
        assertThat(Files.readAllBytes(certificate)).isEqualTo(before);
    }

    @Test
    void fileThatIsNoCertificate_isRefusedWithASentence() throws IOException {
        Path file = Files.writeString(folder.resolve("no.p12"), "no");
        var network = new TlsNetwork(place(freePort(), 7800, file));
        assertThatThrownBy(() -> network.join(new Heard())).isInstanceOf(JoinException.class).hasMessageContaining("no.p12")
                .hasMessageContaining("expected a key");
        network.close();
    }
}
