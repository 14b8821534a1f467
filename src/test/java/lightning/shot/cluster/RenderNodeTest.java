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
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import lightning.base.file.ContentHash;
import lightning.base.work.Await;
import lightning.base.work.NiceValue;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.shot.ForwardingFrameHost;
import lightning.shot.FrameHost;
import lightning.shot.FrameRejectedException;
import lightning.shot.FrameUpdate;
import lightning.shot.HostLostException;
import lightning.shot.LocalFrameHost;
import lightning.shot.ShotRevision;
import lightning.shot.cluster.wire.Message;
import lightning.shot.cluster.wire.MessageCodec;
import lightning.shot.cluster.wire.SceneManifest;
import lightning.shot.cluster.wire.WireException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Tests a node's handling of messages that no coordinator sends. */
final class RenderNodeTest {
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
    private final List<String> log = Collections.synchronizedList(new ArrayList<>());
    private volatile Runnable beforeUpdate = () -> {};
    private RenderNode node;
    private Peer peer;

    /** Member that sends arbitrary messages. */
    private static final class Peer implements ClusterNetwork.Listener {
        private final LocalNetwork.Endpoint end;
        private final BlockingQueue<Set<ClusterMember>> views = new LinkedBlockingQueue<>();
        private final BlockingQueue<Message> answers = new LinkedBlockingQueue<>();
        private final Map<ContentHash, byte[]> contents = new HashMap<>();
        private ClusterMember node;

        Peer(LocalNetwork.Endpoint end) throws InterruptedException {
            this.end = end;
            end.join(this);
            node = views.poll(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS).iterator().next();
        }

        @Override
        public void messageReceived(ClusterMember from, byte[] bytes) {
            try {
                Message message = MessageCodec.decode(bytes);
                if (message instanceof Message.RequestContent need) {
                    send(new Message.ContentPart(need.session(), need.hash(), need.offset(),
                            contents.getOrDefault(need.hash(), new byte[0])));
                } else {
                    answers.add(message);
                }
            } catch (WireException e) {
                throw new AssertionError(e);
            }
        }

        @Override
        public void membersChanged(Set<ClusterMember> others) {
            views.add(others);
        }

        void send(Message message) {
            end.send(node, MessageCodec.encode(message));
        }

        void sendBytes(byte[] bytes) {
            end.send(node, bytes);
        }

        <M extends Message> M await(Class<M> type) throws InterruptedException {
            Message message = answers.poll(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS);
            assertThat(message).isInstanceOf(type);
            return type.cast(message);
        }

        void sendUpdate(long call, Map<String, SceneManifest.Content> files, SceneManifest.Content text) {
            byte[] manifest = new SceneManifest(text, new TreeMap<>(files)).encode();
            contents.put(ContentHash.of(manifest), manifest);
            send(new Message.UpdateFrame(SESSION, call, 1, ContentHash.of(manifest), manifest.length));
        }
    }

    /** Host that runs {@link #beforeUpdate} before each update. */
    private final class HookedHost extends ForwardingFrameHost {
        HookedHost(FrameHost host) {
            super(host);
        }

        @Override
        public FrameUpdate update(int frame, ShotRevision revision, Progress progress) throws HostLostException {
            beforeUpdate.run();
            return super.update(frame, revision, progress);
        }
    }

    @BeforeEach
    void start() throws Exception {
        node = new RenderNode(network.addEndpoint(), new RenderNode.Settings("r", 1, 1 << 30, folder.resolve("own"),
                () -> new HookedHost(new LocalFrameHost(RenderOptions.DEFAULT.withThreads(1), 1 << 28)), log::add));
        node.start();
        peer = new Peer(network.addEndpoint());
        peer.contents.put(ContentHash.of(TEXT), TEXT);
        peer.send(new Message.OpenSession(SESSION, "r"));
        assertThat(peer.await(Message.SessionOpened.class).threads()).isEqualTo(1);
    }

    @AfterEach
    void end() throws Exception {
        node.close();
        peer.end.close();
        Await.untilThreadEnded("lightning-node");
    }

    private static SceneManifest.Content text() {
        return new SceneManifest.Content(ContentHash.of(TEXT), TEXT.length);
    }

    @Test
    void invalidBytes_areReportedOnce() throws Exception {
        byte[] bring = MessageCodec.encode(new Message.CancelUpdate(SESSION, 1));
        bring[2] = 2;
        peer.sendBytes(bring);
        peer.sendBytes(new byte[0]);
        peer.sendBytes(new byte[Message.MAX_BYTES + 1]);
        peer.sendBytes("rO0ABXNyABFqYXZhLnV0aWwuSGFzaE1hcA==".getBytes(StandardCharsets.UTF_8));
        peer.sendUpdate(1, Map.of(), text());
        assertThat(peer.await(Message.FrameUpdated.class).width()).isEqualTo(40);
        assertThat(log).filteredOn(line -> line.contains("ignoring")).singleElement().asString()
                .contains("expected protocol version 1, found 2");
    }

    @Test
    void contentWithWrongHash_isRejected() throws Exception {
        byte[] other = TEXT.clone();
        other[0] = 'x';
        peer.contents.put(ContentHash.of(TEXT), other);
        peer.sendUpdate(1, Map.of(), text());
        Message.UpdateFailed failed = peer.await(Message.UpdateFailed.class);
        assertThat(failed.reason()).isEqualTo(Message.FailureReason.INVALID);
        assertThat(failed.message()).contains("does not match its hash");
    }

    @Test
    void contentThatDoesNotFit_isRejected() throws Exception {
        Files.delete(folder.resolve("own/contents"));
        Files.writeString(folder.resolve("own/contents"), "no folder");
        peer.sendUpdate(1, Map.of(), text());
        assertThat(peer.await(Message.UpdateFailed.class).reason()).isEqualTo(Message.FailureReason.REJECTED);
    }

    @Test
    void tooLargeContent_isRejectedBeforeTransfer() throws Exception {
        peer.sendUpdate(1, Map.of(), new SceneManifest.Content(ContentHash.of(TEXT), 1L << 40));
        assertThat(peer.await(Message.UpdateFailed.class).message())
                .contains("expected content of at most 268435456 bytes, found 1099511627776");
    }

    @Test
    void pathOutsideFolder_isRejected() throws Exception {
        for (String name : List.of("../stolen.png", "/etc/passwd", "a/../../b", "")) {
            peer.sendUpdate(name.hashCode() & 0xff, Map.of(name, text()), text());
            assertThat(peer.await(Message.UpdateFailed.class).message()).contains("expected a file name relative to the scene");
        }
        assertThat(folder).isDirectoryNotContaining("glob:**stolen*");
    }

    @Test
    void invalidScene_isRejectedWithProblems() throws Exception {
        byte[] text = "jen 1\nsphere ball { at 1 }\n".getBytes(StandardCharsets.UTF_8);
        peer.contents.put(ContentHash.of(text), text);
        peer.sendUpdate(1, Map.of(), new SceneManifest.Content(ContentHash.of(text), text.length));
        assertThat(peer.await(Message.UpdateFailed.class).reason()).isEqualTo(Message.FailureReason.INVALID);
    }

    @Test
    void lostAnswer_isResent() throws Exception {
        peer.sendUpdate(1, Map.of(), text());
        Message.FrameUpdated first = peer.await(Message.FrameUpdated.class);
        peer.sendUpdate(1, Map.of(), text());
        assertThat(peer.await(Message.FrameUpdated.class)).isEqualTo(first);
    }

    @Test
    void filmOfOlderRequest_isUnavailable() throws Exception {
        peer.sendUpdate(1, Map.of(), text());
        peer.await(Message.FrameUpdated.class);
        peer.sendUpdate(2, Map.of(), text());
        peer.await(Message.FrameUpdated.class);
        peer.send(new Message.RequestTiles(SESSION, 1, 1, 1000, 1000, 0, 1));
        assertThat(peer.await(Message.FilmUnavailable.class).call()).isEqualTo(1);
        peer.send(new Message.RequestTiles(SESSION, 2, 1, 1000, 1000, 0, 2));
        assertThat(peer.await(Message.FilmTileData.class).bytes()).hasSize(2 * 3 * 1024 * 4);
        peer.send(new Message.RequestTiles(SESSION, 2, 1, 1000, 1000, 1, 2));
        peer.await(Message.FilmUnavailable.class);
    }

    @Test
    void foreignMember_cannotUseSession() throws Exception {
        var other = new Peer(network.addEndpoint());
        // The peer is notified before the node receives further requests.
        other.node = peer.node;
        other.send(new Message.UpdateFrame(SESSION, 1, 1, ContentHash.of(TEXT), 10));
        other.send(new Message.CloseSession(SESSION));
        peer.sendUpdate(2, Map.of(), text());
        peer.await(Message.FrameUpdated.class);
        assertThat(other.answers).isEmpty();
        other.end.close();
    }

    @Test
    void requestInUnknownSession_isAnswered() throws Exception {
        peer.send(new Message.FocusFrame(new UUID(9, 9), 1));
        assertThat(peer.await(Message.CloseSession.class).session()).isEqualTo(new UUID(9, 9));
    }

    /** JGroups' threads run before tracing threads, and do not inherit their priority. */
    @Test
    @EnabledOnOs(OS.LINUX)
    void frames_areTracedWithLowPriority() throws Exception {
        var sender = new CompletableFuture<Integer>();
        network.observe(bytes -> {
            if (LocalNetwork.decode(bytes) instanceof Message.UpdateFailed) {
                sender.complete(NiceValue.ofThread());
            }
        });
        beforeUpdate = () -> {
            throw new FrameRejectedException("nice " + NiceValue.ofThread());
        };
        peer.sendUpdate(1, Map.of(), text());
        assertThat(peer.await(Message.UpdateFailed.class).message())
                .isEqualTo("nice " + Math.min(NiceValue.MAX, NiceValue.ofThread() + 10));
        assertThat(sender.get(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)).isEqualTo(NiceValue.ofThread());
    }

    @Test
    void contentOfEndedNode_isRemoved() throws Exception {
        peer.sendUpdate(1, Map.of(), text());
        peer.await(Message.FrameUpdated.class);
        assertThat(folder.resolve("own/contents")).isNotEmptyDirectory();
        node.close();
        assertThat(Files.exists(folder.resolve("own/contents"))).isFalse();
    }

    @Test
    void contentAfterEnd_isNotStored() throws Exception {
        Path contentFolder = folder.resolve("ended");
        var contents = new ContentFolder(contentFolder);
        contents.clear();
        assertThatThrownBy(() -> contents.sceneFolder(new SceneManifest(text(), new TreeMap<>()), (_, _) -> TEXT))
                .isInstanceOf(IOException.class);
        // Its lock, which the next node takes over.
        assertThat(contentFolder.toFile().list()).containsExactly("in-use");
    }

    @Test
    void folderInUse_isRejectedUnchanged() throws Exception {
        peer.sendUpdate(1, Map.of(), text());
        peer.await(Message.FrameUpdated.class);
        Path nodeFolder = folder.resolve("own");
        assertThatThrownBy(() -> new ContentFolder(nodeFolder)).isInstanceOf(IOException.class)
                .hasMessage(nodeFolder + ": another node uses this folder; choose another one with --folder");
        assertThat(nodeFolder.resolve("contents")).isNotEmptyDirectory();
        node.close();
        new ContentFolder(nodeFolder).clear();
    }

    @Test
    void lateOpenSession_atEndedNode_isIgnored() {
        node.close();
        node.messageReceived(new ClusterMember(UUID.randomUUID()), MessageCodec.encode(new Message.OpenSession(new UUID(5, 6), "r")));
        assertThat(log).containsExactly("rendering for member 1");
    }
}
