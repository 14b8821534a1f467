package lightning.shot.cluster;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import lightning.base.text.ReleaseInfo;
import lightning.sample.Nightly;
import lightning.shot.ShotListener;
import lightning.shot.ShotRelighter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Starts three nodes and a client at the same moment. {@code -Dlightning.starts=50} repeats it as often. Prints the seconds until all nodes
 * are in use. {@link ClusterTest} starts nodes one after the other in the usual check.
 */
@Nightly
final class ConcurrentStartTest {
    private static final int STARTS = Integer.getInteger("lightning.starts", 1);
    private static final int NODES = 3;
    /**
     * Counted from the moment when all nodes have joined. On an idle machine it takes up to 6; a split that does not heal lasts for
     * minutes.
     */
    private static final int TIMEOUT_SECONDS = Integer.getInteger("lightning.starts.seconds", 60);
    private static final int START_SECONDS = 180;

    @TempDir
    private Path folder;

    @Test
    void firstNodeAndTwoJoining_areAllUsed() throws Exception {
        startRepeatedly("one named", false);
    }

    @Test
    void nodesJoiningEachOther_areAllUsed() throws Exception {
        startRepeatedly("all named", true);
    }

    private void startRepeatedly(String name, boolean joinAll) throws Exception {
        SelfSignedCertificate.write(folder.resolve("shared.p12"));
        List<Double> seconds = new ArrayList<>();
        for (int start = 0; start < STARTS; start++) {
            seconds.add(start(name + " " + start, joinAll));
            System.out.printf(Locale.ROOT, "%s: start %d: %.1f s%n", name, start + 1, seconds.getLast());
        }
        assertThat(seconds).allMatch(s -> s <= TIMEOUT_SECONDS);
    }

    /** Returns the seconds from the moment when all nodes have joined until all are in use. */
    private double start(String name, boolean joinAll) throws Exception {
        Path nodeFolder = Files.createDirectory(folder.resolve(name));
        Files.copy(folder.resolve("shared.p12"), nodeFolder.resolve("shared.p12"));
        List<Integer> ports = List.of(FreePort.next(), FreePort.next(), FreePort.next());
        List<NodeProcess> nodes = new ArrayList<>();
        InetAddress loopback = InetAddress.getLoopbackAddress();
        var config = new NodeConfig(loopback, NodeConfig.CLIENT_PORT, NodeConfig.CLIENT_PORTS,
                List.of(new InetSocketAddress(loopback, ports.getFirst())),
                nodeFolder.resolve("shared.p12"), NodeConfig.Timing.DEFAULT);
        try (ShotRelighter shot = ShotRelighter.of(1, 2, ShotListener.NONE);
                NodePool machines = new NodePool(new TlsNetwork(config), ReleaseInfo.machineText(), nodeFolder, shot, _ -> {})) {
            for (int port : ports) {
                nodes.add(new NodeProcess(port, joinAll ? ports : port == ports.getFirst() ? List.of() : List.of(ports.getFirst()),
                        nodeFolder));
            }
            machines.start();
            long begin = System.nanoTime();
            long ready = 0;
            while (machines.count() < NODES) {
                long now = System.nanoTime();
                if (ready == 0 && isMember(nodeFolder, ports.get(0)) && isMember(nodeFolder, ports.get(1))
                        && isMember(nodeFolder, ports.get(2))) {
                    ready = now;
                }
                boolean late = ready == 0 ? now - begin > TimeUnit.SECONDS.toNanos(START_SECONDS)
                        : now - ready > TimeUnit.SECONDS.toNanos(TIMEOUT_SECONDS);
                if (late) {
                    return Double.POSITIVE_INFINITY;
                }
                Thread.sleep(20);
            }
            return ready == 0 ? 0 : (System.nanoTime() - ready) / 1e9;
        } finally {
            for (NodeProcess node : nodes) {
                node.kill();
            }
        }
    }

    private static boolean isMember(Path folder, int port) throws IOException {
        return Files.readString(folder.resolve("node-" + port + ".log")).contains("node running at");
    }
}
