package lightning.shot.cluster;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import javax.net.ssl.SSLException;
import javax.net.ssl.SSLSocket;
import lightning.base.work.Wait;
import lightning.sample.Slow;
import org.jgroups.Address;
import org.jgroups.BytesMessage;
import org.jgroups.LongMessage;
import org.jgroups.Message;
import org.jgroups.MessageFactory;
import org.jgroups.ObjectMessage;
import org.jgroups.View;
import org.jgroups.util.ByteArrayDataInputStream;
import org.jgroups.util.ByteArrayDataOutputStream;
import org.jgroups.util.Digest;
import org.jgroups.util.MutableDigest;
import org.jgroups.util.ObjectWrapperSerializable;
import org.jgroups.util.SeqnoList;
import org.jgroups.util.UUID;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

@Slow
final class TlsNetworkTest {
    private static final Place.Timing QUICK = new Place.Timing(500, 8000, 1000, 1500);

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
            Set<Member> view = views.poll(Wait.MOST_SECONDS, TimeUnit.SECONDS);
            assertThat(view).as("a change of members").isNotNull();
            return view;
        }
    }

    private static Place place(int port, int join, Path certificate) {
        InetAddress here = InetAddress.getLoopbackAddress();
        return new Place(here, port, 1, List.of(new InetSocketAddress(here, join)), certificate, QUICK);
    }

    @Test
    void membersOfOneCertificate_hearEachOther() throws Exception {
        int first = FreePort.next();
        int second = FreePort.next();
        var a = new Heard();
        var b = new Heard();
        try (var one = new TlsNetwork(place(first, first, certificate)); var two = new TlsNetwork(place(second, first, certificate))) {
            one.join(a);
            two.join(b);
            Member to = a.awaitOthers(1).iterator().next();
            byte[] large = new byte[1 << 20];
            large[5] = 7;
            one.send(to, large);
            assertThat(b.messages.poll(Wait.MOST_SECONDS, TimeUnit.SECONDS)).isEqualTo(large);
            assertThat(one.name(to)).isEqualTo("127.0.0.1:" + second);
        }
    }

    /** JGroups lets a member send some megabytes before it must hear that these were taken. */
    @Test
    void moreThanAMemberTakesAtOnce_arrivesWhole() throws Exception {
        int first = FreePort.next();
        var a = new Heard();
        var b = new Heard();
        try (var one = new TlsNetwork(place(first, first, certificate));
                var two = new TlsNetwork(place(FreePort.next(), first, certificate))) {
            one.join(a);
            two.join(b);
            Member to = a.awaitOthers(1).iterator().next();
            Thread sender = Thread.ofPlatform().daemon().start(() -> {
                for (int i = 0; i < 24; i++) {
                    byte[] message = new byte[1 << 20];
                    message[0] = (byte) i;
                    one.send(to, message);
                }
            });
            for (int i = 0; i < 24; i++) {
                assertThat(b.messages.poll(Wait.MOST_SECONDS, TimeUnit.SECONDS)).as("message " + i).hasSize(1 << 20).startsWith(i);
            }
            sender.join();
        }
    }

    @Test
    void strangerWithAnotherCertificate_staysAlone() throws Exception {
        int first = FreePort.next();
        var a = new Heard();
        var stranger = new Heard();
        try (var one = new TlsNetwork(place(first, first, certificate)); var two = new TlsNetwork(place(FreePort.next(), first, other))) {
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
        int port = FreePort.next();
        try (var one = new TlsNetwork(place(port, port, certificate))) {
            one.join(new Heard());
            // It trusts whomever it meets, but has nothing to show.
            var context = javax.net.ssl.SSLContext.getInstance("TLSv1.3");
            context.init(null, new javax.net.ssl.TrustManager[] {new TrustsAll()}, null);
            try (SSLSocket socket = (SSLSocket) context.getSocketFactory().createSocket(InetAddress.getLoopbackAddress(), port)) {
                socket.setSoTimeout(Wait.MOST_SECONDS * 1000);
                assertThatThrownBy(() -> {
                    socket.startHandshake();
                    // With TLS 1.3 the refusal comes behind the client's own end of the handshake; who was let in hears nothing.
                    socket.getInputStream().read();
                }).isInstanceOf(SSLException.class).hasMessageContaining("certificate");
            }
            try (Socket plain = new Socket(InetAddress.getLoopbackAddress(), port)) {
                plain.setSoTimeout(Wait.MOST_SECONDS * 1000);
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
        int port = FreePort.next();
        try (var one = new TlsNetwork(place(port, port, certificate))) {
            one.join(new Heard());
            for (short type : new short[] {Message.NIO_MSG, Message.COMPOSITE_MSG, Message.FRAG_MSG, Message.EARLYBATCH_MSG}) {
                assertThatThrownBy(() -> MessageFactory.create(type)).isInstanceOf(IllegalArgumentException.class);
            }
            assertThat((Message) MessageFactory.create(Message.BYTES_MSG)).isInstanceOf(BytesMessage.class);
            for (Object object : List.of("words", 1, new View(UUID.randomUUID(), 1, List.of(UUID.randomUUID())),
                    new ObjectWrapperSerializable(new ArrayList<>()))) {
                assertThatThrownBy(() -> again(new ObjectMessage(null, object))).isInstanceOf(IOException.class)
                        .hasMessageContaining("expected numbers of messages, found an object");
            }
        }
    }

    /** What a message is to who reads it. */
    private static Message again(Message message) throws Exception {
        var out = new ByteArrayDataOutputStream();
        message.writeTo(out);
        Message read = MessageFactory.create(message.getType());
        read.readFrom(new ByteArrayDataInputStream(out.buffer(), 0, out.position()));
        return read;
    }

    @Test
    void messagesOfItsProtocols_areRead() throws Exception {
        int port = FreePort.next();
        try (var one = new TlsNetwork(place(port, port, certificate))) {
            one.join(new Heard());
            SeqnoList missing = new SeqnoList(200, 7).add(8, 100, 206);
            SeqnoList wanted = again(new ObjectMessage(null, missing)).getObject();
            assertThat(wanted).containsExactly(8L, 100L, 206L);
            Address[] members = {UUID.randomUUID()};
            var digest = new Digest(members, new long[] {3, 5});
            assertThat(again(new ObjectMessage(null, digest)).<Digest>getObject()).isEqualTo(digest);
            MutableDigest sofar = new MutableDigest(members).set(digest);
            assertThat(again(new ObjectMessage(null, sofar)).<Digest>getObject()).isEqualTo(digest);
            assertThat(again(new LongMessage(null, 5_000_000)).<Long>getObject()).isEqualTo(5_000_000);
            assertThatThrownBy(() -> again(new ObjectMessage(null, new SeqnoList(1 << 21, 7)))).isInstanceOf(IOException.class)
                    .hasMessageContaining("expected 1 to 1048576 numbers of messages");
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
        var network = new TlsNetwork(place(FreePort.next(), 7800, file));
        assertThatThrownBy(() -> network.join(new Heard())).isInstanceOf(JoinException.class).hasMessageContaining("no.p12")
                .hasMessageContaining("expected a key");
        network.close();
    }
}
