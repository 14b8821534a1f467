package lightning.shot.cluster;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import lightning.base.work.Await;
import lightning.base.work.Progress;
import lightning.format.jen.PropertyEdit;
import lightning.render.RenderOptions;
import lightning.render.image.Downscale;
import lightning.render.image.Film;
import lightning.render.image.FilmAssert;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.IndirectScenes;
import lightning.sample.Slow;
import lightning.scene.Scene;
import lightning.shot.FrameState;
import lightning.shot.LocalFrameHost;
import lightning.shot.ShotListener;
import lightning.shot.ShotRelighter;
import lightning.shot.ShotRevision;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Nodes and a coordinator in one process, over a network that loses messages and can be cut. */
@Slow
final class ClusterTest {
    private static final int LAST = 6;

    @TempDir
    private Path folder;

    private final List<AutoCloseable> open = new ArrayList<>();

    private RenderNode node(LocalNetwork.Endpoint end, String release) throws Exception {
        return node(end, release, 1 << 28);
    }

    /** @param room bytes for its frames */
    private RenderNode node(LocalNetwork.Endpoint end, String release, long room) throws Exception {
        Path own = folder.resolve("node" + open.size());
        var node = new RenderNode(end, new RenderNode.Settings(release, 1, 1 << 30, own,
                () -> LocalFrameHost.createPinned(RenderOptions.DEFAULT.withThreads(1), room, own, 0), _ -> {}));
        node.start();
        open.add(node);
        return node;
    }

    private static ShotRevision edited(ShotRevision revision, String assignment) {
        Scene scene = PropertyEdit.apply(revision.scene(), assignment);
        return new ShotRevision(scene, revision.shot());
    }

    private static void awaitAll(ShotRelighter shot) throws Exception {
        Await.until("all frames are current", shot::isIdle);
    }

    /** A node may be lost after all frames were current, while a film is in transit: another then traces it. */
    private static void checkAll(ShotRelighter shot, ShotRevision revision) throws Exception {
        for (int frame = 1; frame <= LAST; frame++) {
            Film film = null;
            while (film == null) {
                awaitAll(shot);
                assertThat(shot.state(frame)).isIn(FrameState.CURRENT, FrameState.MISSING);
                film = shot.film(frame).orElse(null);
            }
            FilmAssert.assertSameBits(film, new ReferenceTracer(revision.sceneAt(frame)).trace(), "cluster-" + frame);
        }
    }

    /** Waits for background work of closed nodes before their folder is removed. */
    @AfterEach
    void closeNodes() throws Exception {
        for (AutoCloseable each : open) {
            each.close();
        }
        Await.untilThreadEnded("lightning-node");
        Await.untilThreadEnded("lightning-films");
    }

    @Test
    void frames_withTextures_areTracedAndRelitByNodes() throws Exception {
        assertTracedAndRelit(textured());
    }

    @Test
    void frames_withIndirectLight_areTracedAndRelitByNodes() throws Exception {
        ShotRevision textured = textured();
        assertTracedAndRelit(new ShotRevision(IndirectScenes.with(textured.scene()), textured.shot()));
    }

    private void assertTracedAndRelit(ShotRevision revision) throws Exception {
        var network = new LocalNetwork(1, 0);
        node(network.addEndpoint(), "r");
        node(network.addEndpoint(), "r");
        try (ShotRelighter shot = ShotRelighter.of(1, LAST, ShotListener.NONE);
                NodePool machines = new NodePool(network.addEndpoint(), "r", folder, shot, _ -> {})) {
            machines.start();
            shot.setRevision(revision);
            checkAll(shot, revision);
            ShotRevision edited = edited(revision, "lamp.intensity=0.3");
            shot.setRevision(edited);
            checkAll(shot, edited);
            assertThat(shot.usage().memoryBytes()).isPositive();
        }
    }

    @Test
    void downscaledFilm_isMeanOfFull() throws Exception {
        ShotRevision revision = textured();
        var network = new LocalNetwork(1, 0);
        node(network.addEndpoint(), "r");
        try (ShotRelighter shot = ShotRelighter.of(1, LAST, ShotListener.NONE);
                NodePool machines = new NodePool(network.addEndpoint(), "r", folder, shot, _ -> {})) {
            machines.start();
            shot.setRevision(revision);
            awaitAll(shot);
            Film full = new ReferenceTracer(revision.sceneAt(3)).trace();
            FilmAssert.assertSameBits(shot.film(3, 20, 9).orElseThrow(), new Downscale(12, 9).apply(full), "small-3");
            FilmAssert.assertSameBits(shot.film(3, 50, 30).orElseThrow(), full, "whole-3");
        }
    }

    private ShotRevision textured() throws Exception {
        var image = new BufferedImage(4, 4, BufferedImage.TYPE_INT_RGB);
        image.setRGB(1, 2, 0xff8040);
        return TexturedShot.write(folder, image, 40, 30, 6);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void reconnectingNodes_duringEdits_loseNoFrame(long seed) throws Exception {
        ShotRevision revision = textured();
        var random = new Random(seed);
        var network = new LocalNetwork(seed, 0.01);
        List<LocalNetwork.Endpoint> ends = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            ends.add(network.addEndpoint());
            node(ends.getLast(), "r");
        }
        try (ShotRelighter shot = ShotRelighter.of(1, LAST, ShotListener.NONE);
                NodePool machines = new NodePool(network.addEndpoint(), "r", folder, shot, _ -> {})) {
            machines.start();
            for (int edit = 0; edit < 12; edit++) {
                revision = edited(revision, "lamp.intensity=" + (1 + edit));
                shot.setRevision(revision);
                shot.focus(1 + random.nextInt(LAST));
                Thread.sleep(random.nextInt(30));
                network.setDisconnected(ends.get(random.nextInt(3)), random.nextBoolean());
                if (random.nextInt(6) == 0) {
                    ends.add(network.addEndpoint());
                    node(ends.getLast(), "r");
                }
            }
            for (LocalNetwork.Endpoint end : ends) {
                network.setDisconnected(end, false);
            }
            checkAll(shot, revision);
        }
    }

    @Test
    void framesOfLostNode_areMissingUntilRetraced() throws Exception {
        ShotRevision revision = textured();
        var network = new LocalNetwork(1, 0);
        LocalNetwork.Endpoint end = network.addEndpoint();
        node(end, "r");
        List<String> lostFrames = Collections.synchronizedList(new ArrayList<>());
        var listener = new ShotListener() {
            @Override
            public void hostLost(lightning.shot.HostLostException problem) {
                lostFrames.add(problem.getMessage());
            }
        };
        try (ShotRelighter shot = ShotRelighter.of(1, LAST, listener);
                NodePool machines = new NodePool(network.addEndpoint(), "r", folder, shot, _ -> {})) {
            machines.start();
            shot.setRevision(revision);
            awaitAll(shot);
            assertThat(machines.count()).isEqualTo(1);
            network.setDisconnected(end, true);
            Await.until("the lost node is reported", () -> !lostFrames.isEmpty());
            assertThat(lostFrames).containsExactly("lost node member 0; its frames are being rendered on other nodes");
            assertThat(shot.state(1)).isEqualTo(FrameState.MISSING);
            assertThat(shot.film(1)).isEmpty();
            node(network.addEndpoint(), "r");
            checkAll(shot, revision);
        }
    }

    @Test
    void nodeThatSawCoordinatorLeave_isReadmitted() throws Exception {
        ShotRevision revision = textured();
        var network = new LocalNetwork(1, 0);
        RenderNode node = node(network.addEndpoint(), "r");
        LocalNetwork.Endpoint asking = network.addEndpoint();
        try (ShotRelighter shot = ShotRelighter.of(1, LAST, ShotListener.NONE);
                NodePool machines = new NodePool(asking, "r", folder, shot, _ -> {})) {
            machines.start();
            shot.setRevision(revision);
            awaitAll(shot);
            node.membersChanged(Set.of());
            checkAll(shot, revision);
        }
    }

    @Test
    void nodeOfOtherRelease_isRejected() throws Exception {
        var network = new LocalNetwork(1, 0);
        node(network.addEndpoint(), "other");
        List<String> log = Collections.synchronizedList(new ArrayList<>());
        try (ShotRelighter shot = ShotRelighter.of(1, LAST, ShotListener.NONE);
                NodePool machines = new NodePool(network.addEndpoint(), "r", folder, shot, log::add)) {
            machines.start();
            Await.until("the ignored node is reported", () -> !log.isEmpty());
            assertThat(log).containsExactly("ignoring member 0: it runs other, this machine r");
            assertThat(machines.count()).isZero();
        }
    }

    @Test
    void frameRejectedByNode_isTracedByAnother_orFails() throws Exception {
        ShotRevision revision = textured();
        long each;
        try (LocalFrameHost host = new LocalFrameHost(RenderOptions.DEFAULT.withThreads(1), 1 << 28)) {
            host.update(1, revision, Progress.NONE);
            each = host.usage().memoryBytes();
        }
        var joined = new AtomicInteger();
        List<String> failed = Collections.synchronizedList(new ArrayList<>());
        var listener = new ShotListener() {
            @Override
            public void frameFailed(int frame, Throwable problem) {
                failed.add(problem.getMessage());
            }

            @Override
            public void hostAdded() {
                joined.incrementAndGet();
            }
        };
        var network = new LocalNetwork(1, 0);
        node(network.addEndpoint(), "r", 5 * each / 2);
        try (ShotRelighter shot = ShotRelighter.of(1, LAST, listener);
                NodePool machines = new NodePool(network.addEndpoint(), "r", folder, shot, _ -> {})) {
            machines.start();
            shot.setRevision(revision);
            awaitAll(shot);
            assertThat(failed).hasSize(LAST - 2).allSatisfy(message -> assertThat(message)
                    .matches("no node has enough memory for it: node member 0: the frame needs about .* MB, but only .* MB is free"));
            node(network.addEndpoint(), "r", LAST * each);
            Await.until("the second node joins", () -> joined.get() == 2);
            checkAll(shot, revision);
            ShotRevision edited = edited(revision, "lamp.at=2 4 3");
            shot.setRevision(edited);
            checkAll(shot, edited);
            assertThat(failed).hasSize(LAST - 2);
        }
    }
}
