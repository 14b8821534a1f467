package lightning.shot.cluster;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import lightning.base.text.Messages;
import lightning.shot.cluster.wire.WireException;

/** Log of members whose messages are unusable; reports each member once. */
final class RejectedPeers {
    private final ClusterNetwork network;
    private final Consumer<String> log;
    private final Set<ClusterMember> reported = ConcurrentHashMap.newKeySet();

    RejectedPeers(ClusterNetwork network, Consumer<String> log) {
        this.network = network;
        this.log = log;
    }

    void report(ClusterMember member, WireException problem) {
        report(member, Messages.tr("invalid message: {0}", problem.getMessage()));
    }

    void report(ClusterMember member, String problem) {
        if (reported.add(member)) {
            log.accept(Messages.tr("ignoring {0}: {1}", network.addressOf(member), problem));
        }
    }
}
