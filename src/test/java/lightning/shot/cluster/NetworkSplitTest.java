package lightning.shot.cluster;

import java.lang.reflect.Field;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import lightning.base.work.Await;
import lightning.sample.Nightly;
import org.jgroups.JChannel;
import org.jgroups.protocols.DISCARD;
import org.jgroups.protocols.TCP;
import org.jgroups.stack.ProtocolStack;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Checks that parts of a cluster that lost each other, or never met, merge: in each pair of members both receive the other's messages.
 * {@link TlsNetworkTest} checks connections in the usual check, without waiting for timeouts.
 */
@Nightly
final class NetworkSplitTest {
    private static final NodeConfig.Timing QUICK = new NodeConfig.Timing(500, 4000, 1000, 1000);
    private static final int MEMBERS = 4;
    private static final int HALF = MEMBERS / 2;
    private static final long PAUSE_MILLISECONDS = 200;

    @TempDir
    private Path folder;

    /** Member with a filter that drops messages. */
    private static final class Endpoint implements ClusterNetwork.Listener, AutoCloseable {
        final TlsNetwork network;
        private final Set<ClusterMember> received = ConcurrentHashMap.newKeySet();
        private volatile Set<ClusterMember> others = Set.of();
        private JChannel channel;
        private DISCARD discard;

        Endpoint(NodeConfig config) {
            network = new TlsNetwork(config);
        }

        void join() throws Exception {
            network.join(this);
            Field field = TlsNetwork.class.getDeclaredField("channel");
            field.setAccessible(true);
            channel = (JChannel) field.get(network);
            discard = new DISCARD();
            channel.getProtocolStack().insertProtocol(discard, ProtocolStack.Position.ABOVE, TCP.class);
        }

        /** Drops all further messages of another member. */
        void disconnectFrom(Endpoint other) {
            discard.addIgnoreMember(other.channel.getAddress());
        }

        void reconnect() {
            discard.resetIgnoredMembers();
        }

        @Override
        public void messageReceived(ClusterMember from, byte[] bytes) {
            received.add(from);
        }

        @Override
        public void membersChanged(Set<ClusterMember> members) {
            others = members;
        }

        @Override
        public void close() {
            network.close();
        }
    }

    @Test
    void splitHalves_mergeAgain() throws Exception {
        SelfSignedCertificate.write(folder.resolve("shared.p12"));
        List<Endpoint> ends = new ArrayList<>();
        try {
            int first = FreePort.next();
            ends.add(join(first, List.of()));
            for (int i = 1; i < MEMBERS; i++) {
                ends.add(join(FreePort.next(), List.of(first)));
            }
            awaitOthers(ends, MEMBERS - 1);
            for (Endpoint one : ends.subList(0, HALF)) {
                for (Endpoint other : ends.subList(HALF, MEMBERS)) {
                    one.disconnectFrom(other);
                    other.disconnectFrom(one);
                }
            }
            awaitOthers(ends, HALF - 1);
            ends.forEach(Endpoint::reconnect);
            awaitAllReachAll(ends);
        } finally {
            close(ends);
        }
    }

    /** Two members of each half know no address of the other half: a common view is not stable until they learn them. */
    @Test
    void halvesStartedSeparately_merge() throws Exception {
        SelfSignedCertificate.write(folder.resolve("shared.p12"));
        List<Endpoint> ends = new ArrayList<>();
        try {
            int first = FreePort.next();
            int second = FreePort.next();
            ends.add(join(second, List.of(first)));
            ends.add(join(FreePort.next(), List.of(second)));
            awaitOthers(ends, HALF - 1);
            ends.add(join(first, List.of()));
            ends.add(join(FreePort.next(), List.of(first)));
            awaitAllReachAll(ends);
        } finally {
            close(ends);
        }
    }

    private Endpoint join(int port, List<Integer> others) throws Exception {
        InetAddress loopback = InetAddress.getLoopbackAddress();
        List<InetSocketAddress> join = others.stream().map(other -> new InetSocketAddress(loopback, other)).toList();
        var end = new Endpoint(new NodeConfig(loopback, port, 1, join, folder.resolve("shared.p12"), QUICK));
        end.join();
        return end;
    }

    private static void close(List<Endpoint> ends) {
        ends.forEach(Endpoint::close);
    }

    private static void awaitOthers(List<Endpoint> ends, int count) throws Exception {
        Await.until("each member sees " + count + " others", () -> ends.stream().allMatch(end -> end.others.size() == count));
    }

    /** Tests with messages rather than views: members of one view may lack each other's addresses. */
    private static void awaitAllReachAll(List<Endpoint> ends) throws Exception {
        awaitOthers(ends, MEMBERS - 1);
        ends.forEach(end -> end.received.clear());
        Await.until("each member receives from all others", () -> {
            ends.forEach(end -> end.others.forEach(other -> end.network.send(other, new byte[1])));
            Thread.sleep(PAUSE_MILLISECONDS);
            return ends.stream().allMatch(end -> end.received.size() == MEMBERS - 1);
        });
    }
}
