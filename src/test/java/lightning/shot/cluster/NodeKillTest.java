package lightning.shot.cluster;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import lightning.base.text.ReleaseInfo;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.format.jen.PropertyEdit;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.sample.Nightly;
import lightning.shot.FrameState;
import lightning.shot.HostLostException;
import lightning.shot.ShotListener;
import lightning.shot.ShotRelighter;
import lightning.shot.ShotRevision;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/**
 * Kills and restarts three node processes at random moments during edits, and compares every film of every frame with its full trace.
 * {@code -Dlightning.kills=100} kills as often, and suspends every tenth node until it counts as lost. {@link RenderNodeTest} and {@link
 * ClusterTest} end nodes in the usual check.
 */
@Nightly
final class NodeKillTest {
    private static final int KILLS = Integer.getInteger("lightning.kills", 1);
    private static final int NODES = 3;
    private static final int LAST = 12;
    private static final long TIMEOUT_NANOSECONDS = 240_000_000_000L;
    /** Longer than the silence timeout and the check together. */
    private static final long STOPPED_MILLISECONDS = 22_000;

    @TempDir
    private Path folder;

    @Test
    @EnabledOnOs({OS.LINUX, OS.MAC})
    void randomlyKilledNodes_loseNoFrame() throws Exception {
        ShotRevision revision = revision();
        SelfSignedCertificate.write(folder.resolve("shared.p12"));
        List<Integer> ports = new ArrayList<>();
        for (int i = 0; i < NODES; i++) {
            ports.add(FreePort.next());
        }
        var random = new Random(KILLS);
        var lost = new AtomicInteger();
        var listener = new ShotListener() {
            @Override
            public void hostLost(HostLostException problem) {
                lost.incrementAndGet();
            }
        };
        List<NodeProcess> nodes = new ArrayList<>();
        try {
            for (int port : ports) {
                nodes.add(new NodeProcess(port, ports, folder));
            }
            InetAddress loopback = InetAddress.getLoopbackAddress();
            var config = new NodeConfig(loopback, NodeConfig.CLIENT_PORT, NodeConfig.CLIENT_PORTS,
                    ports.stream().map(port -> new InetSocketAddress(loopback, port)).toList(), folder.resolve("shared.p12"),
                    NodeConfig.Timing.DEFAULT);
            try (ShotRelighter shot = ShotRelighter.of(1, LAST, listener);
                    NodePool machines = new NodePool(new TlsNetwork(config), ReleaseInfo.machineText(), folder, shot, _ -> {});
                    WorkerPool workers = new WorkerPool(2)) {
                machines.start();
                await("all nodes are in use", () -> machines.count() == NODES);
                shot.setRevision(revision);
                awaitAll(shot);
                for (int kill = 0; kill < KILLS; kill++) {
                    revision = new ShotRevision(PropertyEdit.apply(revision.scene(), edit(random)), revision.shot());
                    shot.setRevision(revision);
                    shot.focus(1 + random.nextInt(LAST));
                    Thread.sleep(random.nextInt(150));
                    int which = random.nextInt(NODES);
                    if (kill % 10 == 9) {
                        nodes.get(which).setSuspended(true);
                        Thread.sleep(STOPPED_MILLISECONDS);
                        revision = new ShotRevision(PropertyEdit.apply(revision.scene(), edit(random)), revision.shot());
                        shot.setRevision(revision);
                        Thread.sleep(random.nextInt(500));
                        nodes.get(which).setSuspended(false);
                    } else {
                        nodes.get(which).kill();
                        nodes.set(which, new NodeProcess(ports.get(which), ports, folder));
                    }
                    checkAll(shot, revision, workers);
                }
                // The loss of a node without frames is noticed only by its silence.
                await("a node is known to be lost", () -> lost.get() > 0);
            }
        } finally {
            for (NodeProcess node : nodes) {
                node.kill();
            }
        }
    }

    /** Returns an edit with or without rays. */
    private static String edit(Random random) {
        return switch (random.nextInt(3)) {
            case 0 -> "lamp.intensity=" + (1 + random.nextInt(100)) / 50.0;
            case 1 -> "lamp.at=" + (random.nextInt(80) - 40) / 10.0 + " 4 5";
            default -> "material:red.diffuse=0." + (1 + random.nextInt(8)) + " 0.2 0.1";
        };
    }

    private ShotRevision revision() throws Exception {
        Path scene = Files.writeString(folder.resolve("a.jen"), """
                jen 1
                picture { size 160 100  depth 2 }
                camera { from 0 2 7  to 0 0.5 0  fov 35 }
                material floor { diffuse 0.7 0.7 0.6  reflective 0.2 0.3 0.2 }
                material red { diffuse 0.8 0.1 0.1  specular 0.4 0.4 0.4  shininess 20 }
                plane ground { material floor  scale 8 1 8 }
                sphere ball { material red  at 0 1 0 }
                cone hat { material red  at 2 0 0.5 }
                light lamp point { at -3 4 3  attenuation 0.2 0.1 0.02 }
                light stage spot { at 0 5 3  direction 0 -5 -3  angle 20  dropoff 4 }
                shot { frames 1 12 camera { from { 1 0 2 7  12 3 2 6 } } }
                """);
        JenDocument document = JenReader.read(scene);
        return new ShotRevision(document.scene(), document.shot().orElseThrow());
    }

    private static void awaitAll(ShotRelighter shot) throws InterruptedException {
        await("all frames are current", shot::isIdle);
    }

    private static void await(String description, BooleanSupplier condition) throws InterruptedException {
        long start = System.nanoTime();
        while (!condition.getAsBoolean()) {
            assertThat(System.nanoTime() - start).as("nanoseconds until " + description).isLessThan(TIMEOUT_NANOSECONDS);
            Thread.sleep(5);
        }
    }

    private static void checkAll(ShotRelighter shot, ShotRevision revision, WorkerPool workers) throws InterruptedException {
        for (int frame = 1; frame <= LAST; frame++) {
            Film film = null;
            while (film == null) {
                awaitAll(shot);
                assertThat(shot.state(frame)).isIn(FrameState.CURRENT, FrameState.MISSING);
                film = shot.film(frame).orElse(null);
            }
            Film traced = new TraditionalTracer(revision.sceneAt(frame)).trace(workers, Progress.NONE).film();
            assertThat(film.hasSameBits(traced)).as("frame " + frame).isTrue();
        }
    }
}
