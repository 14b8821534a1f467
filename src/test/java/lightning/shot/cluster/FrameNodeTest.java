package lightning.shot.cluster;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.UUID;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import lightning.base.work.Wait;
import lightning.render.relight.tile.Options;
import lightning.shot.LocalKeeper;
import lightning.shot.cluster.wire.Bill;
import lightning.shot.cluster.wire.Codec;
import lightning.shot.cluster.wire.Hash;
import lightning.shot.cluster.wire.Message;
import lightning.shot.cluster.wire.WireException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a node does with messages that no coordinator sends. */
final class FrameNodeTest {
    private static final UUID SESSION = new UUID(3, 4);
    private static final byte[] TEXT = """
            jen 1
            picture { size 40 30 }
            sphere ball { }
            light lamp point { at 0 3 3 }
            """.getBytes(StandardCharsets.UTF_8);

    @TempDir
    private Path folder;

    private final LocalNetwork network = new LocalNetwork(1, 0);
    private final List<String> said = Collections.synchronizedList(new ArrayList<>());
    private FrameNode node;
    private Peer peer;

    /** A member that sends what it likes. */
    private static final class Peer implements Network.Listener {
        private final LocalNetwork.End end;
        private final BlockingQueue<Set<Member>> views = new LinkedBlockingQueue<>();
        private final BlockingQueue<Message> answers = new LinkedBlockingQueue<>();
        private final Map<Hash, byte[]> contents = new HashMap<>();
        private Member node;

        Peer(LocalNetwork.End end) throws InterruptedException {
            this.end = end;
            end.join(this);
            node = views.poll(Wait.MOST_SECONDS, TimeUnit.SECONDS).iterator().next();
        }

        @Override
        public void heard(Member from, byte[] bytes) {
            try {
                Message message = Codec.decode(bytes);
                if (message instanceof Message.Need need) {
                    send(new Message.Part(need.session(), need.hash(), need.offset(), contents.getOrDefault(need.hash(), new byte[0])));
                } else {
                    answers.add(message);
                }
            } catch (WireException e) {
                throw new AssertionError(e);
            }
        }

        @Override
        public void changed(Set<Member> others) {
            views.add(others);
        }

        void send(Message message) {
            end.send(node, Codec.encode(message));
        }

        void sendBytes(byte[] bytes) {
            end.send(node, bytes);
        }

        <M extends Message> M await(Class<M> type) throws InterruptedException {
            Message message = answers.poll(Wait.MOST_SECONDS, TimeUnit.SECONDS);
            assertThat(message).isInstanceOf(type);
            return type.cast(message);
        }

        void bring(long call, Map<String, Bill.Content> files, Bill.Content text) {
            byte[] bill = new Bill(text, new TreeMap<>(files)).encode();
            contents.put(Hash.of(bill), bill);
            send(new Message.Bring(SESSION, call, 1, Hash.of(bill), bill.length));
        }
    }

    @BeforeEach
    void start() throws Exception {
        node = new FrameNode(network.end(), new FrameNode.Settings("r", 1, 1 << 30, folder.resolve("own"),
                () -> new LocalKeeper(Options.DEFAULT.withThreads(1), 1 << 28), said::add));
        node.start();
        peer = new Peer(network.end());
        peer.contents.put(Hash.of(TEXT), TEXT);
        peer.send(new Message.Hello(SESSION, "r"));
        assertThat(peer.await(Message.Ready.class).threads()).isEqualTo(1);
    }

    @AfterEach
    void end() throws Exception {
        node.close();
        peer.end.close();
        Wait.untilEnded("lightning-node");
    }

    private static Bill.Content text() {
        return new Bill.Content(Hash.of(TEXT), TEXT.length);
    }

    @Test
    void bytesThatAreNoMessage_areToldOnceAndChangeNothing() throws Exception {
        byte[] bring = Codec.encode(new Message.Cancel(SESSION, 1));
        bring[2] = 2;
        peer.sendBytes(bring);
        peer.sendBytes(new byte[0]);
        peer.sendBytes(new byte[Message.MOST_BYTES + 1]);
        peer.sendBytes("rO0ABXNyABFqYXZhLnV0aWwuSGFzaE1hcA==".getBytes(StandardCharsets.UTF_8));
        peer.bring(1, Map.of(), text());
        assertThat(peer.await(Message.Brought.class).width()).isEqualTo(40);
        assertThat(said).filteredOn(sentence -> sentence.contains("left aside")).singleElement().asString()
                .contains("expected version 1 of the protocol, found 2");
    }

    @Test
    void contentWithOtherBytesThanItsHash_isRefused() throws Exception {
        byte[] other = TEXT.clone();
        other[0] = 'x';
        peer.contents.put(Hash.of(TEXT), other);
        peer.bring(1, Map.of(), text());
        Message.Failed failed = peer.await(Message.Failed.class);
        assertThat(failed.reason()).isEqualTo(Message.Reason.UNUSABLE);
        assertThat(failed.sentence()).contains("other bytes than its hash says");
    }

    @Test
    void contentThatTheDiskDoesNotTake_isForAnotherNode() throws Exception {
        Files.delete(folder.resolve("own/contents"));
        Files.writeString(folder.resolve("own/contents"), "no folder");
        peer.bring(1, Map.of(), text());
        assertThat(peer.await(Message.Failed.class).reason()).isEqualTo(Message.Reason.REFUSED);
    }

    @Test
    void contentLongerThanItsKindMayBe_isRefusedBeforeItIsAskedFor() throws Exception {
        peer.bring(1, Map.of(), new Bill.Content(Hash.of(TEXT), 1L << 40));
        assertThat(peer.await(Message.Failed.class).sentence())
                .contains("expected content of at most 268435456 bytes, found 1099511627776");
    }

    @Test
    void nameThatLeadsElsewhere_isRefused() throws Exception {
        for (String name : List.of("../stolen.png", "/etc/passwd", "a/../../b", "")) {
            peer.bring(name.hashCode() & 0xff, Map.of(name, text()), text());
            assertThat(peer.await(Message.Failed.class).sentence()).contains("expected the name of a file beside a scene");
        }
        assertThat(folder).isDirectoryNotContaining("glob:**stolen*");
    }

    @Test
    void sceneThatIsNone_isRefusedWithItsProblems() throws Exception {
        byte[] text = "jen 1\nsphere ball { at 1 }\n".getBytes(StandardCharsets.UTF_8);
        peer.contents.put(Hash.of(text), text);
        peer.bring(1, Map.of(), new Bill.Content(Hash.of(text), text.length));
        assertThat(peer.await(Message.Failed.class).reason()).isEqualTo(Message.Reason.UNUSABLE);
    }

    @Test
    void answerThatWasLost_isGivenAgain() throws Exception {
        peer.bring(1, Map.of(), text());
        Message.Brought first = peer.await(Message.Brought.class);
        peer.bring(1, Map.of(), text());
        assertThat(peer.await(Message.Brought.class)).isEqualTo(first);
    }

    @Test
    void filmOfAnOlderWish_isGone() throws Exception {
        peer.bring(1, Map.of(), text());
        peer.await(Message.Brought.class);
        peer.bring(2, Map.of(), text());
        peer.await(Message.Brought.class);
        peer.send(new Message.Ask(SESSION, 1, 1, 1000, 1000, 0, 1));
        assertThat(peer.await(Message.Gone.class).call()).isEqualTo(1);
        peer.send(new Message.Ask(SESSION, 2, 1, 1000, 1000, 0, 2));
        assertThat(peer.await(Message.Pixels.class).bytes()).hasSize(2 * 3 * 1024 * 4);
        peer.send(new Message.Ask(SESSION, 2, 1, 1000, 1000, 1, 2));
        peer.await(Message.Gone.class);
    }

    @Test
    void otherMember_doesNothingInASessionThatIsNotItsOwn() throws Exception {
        var other = new Peer(network.end());
        // The peer hears of it before the node is asked for more.
        other.node = peer.node;
        other.send(new Message.Bring(SESSION, 1, 1, Hash.of(TEXT), 10));
        other.send(new Message.End(SESSION));
        peer.bring(2, Map.of(), text());
        peer.await(Message.Brought.class);
        assertThat(other.answers).isEmpty();
        other.end.close();
    }

    @Test
    void wishInASessionThatTheNodeHasNot_isToldSo() throws Exception {
        peer.send(new Message.Focus(new UUID(9, 9), 1));
        assertThat(peer.await(Message.End.class).session()).isEqualTo(new UUID(9, 9));
    }

    @Test
    void contentOfAnEndedNode_isRemoved() throws Exception {
        peer.bring(1, Map.of(), text());
        peer.await(Message.Brought.class);
        assertThat(folder.resolve("own/contents")).isNotEmptyDirectory();
        node.close();
        assertThat(Files.exists(folder.resolve("own/contents"))).isFalse();
    }

    @Test
    void contentThatComesAfterItsEnd_isNotKept() throws Exception {
        Path own = folder.resolve("ended");
        var contents = new ContentFolder(own);
        contents.clear();
        assertThatThrownBy(() -> contents.scene(new Bill(text(), new TreeMap<>()), (_, _) -> TEXT)).isInstanceOf(IOException.class);
        // Its lock, which the next node takes.
        assertThat(own.toFile().list()).containsExactly("in-use");
    }

    @Test
    void folderOfANodeThatRuns_isRefused_andItsContentStays() throws Exception {
        peer.bring(1, Map.of(), text());
        peer.await(Message.Brought.class);
        Path own = folder.resolve("own");
        assertThatThrownBy(() -> new ContentFolder(own)).isInstanceOf(IOException.class)
                .hasMessage(own + ": another node uses this folder; name another one with --folder");
        assertThat(own.resolve("contents")).isNotEmptyDirectory();
        node.close();
        new ContentFolder(own).clear();
    }

    @Test
    void helloThatAnEndedNodeHearsLate_beginsNothing() {
        node.close();
        node.heard(new Member(UUID.randomUUID()), Codec.encode(new Message.Hello(new UUID(5, 6), "r")));
        assertThat(said).containsExactly("holds frames for member 1");
    }
}
