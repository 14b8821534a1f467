package lightning.shot.cluster;

import static java.util.Objects.requireNonNull;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import lightning.base.text.Messages;
import lightning.base.work.DedicatedThread;
import lightning.shot.ShotRelighter;
import lightning.shot.cluster.wire.Message;
import lightning.shot.cluster.wire.MessageCodec;
import lightning.shot.cluster.wire.WireException;

/** Pool of the nodes of a cluster as hosts of a shot: adds nodes that join, and removes lost ones. */
public final class NodePool implements ClusterNetwork.Listener, AutoCloseable {
    private static final long HELLO_MILLISECONDS = 1000;
    /** Timeout of a node that is still a member: each side may have another view of the members. */
    private static final long SILENCE_TIMEOUT_NANOSECONDS = 20_000_000_000L;

    /** Time without any node before joining again; the parts of a split cluster need at most this to merge. */
    private static final long REJOIN_NANOSECONDS = 15_000_000_000L;
    /** Time for recently seen members to answer before this process joins again. */
    private static final long ANSWER_TIMEOUT_NANOSECONDS = 5_000_000_000L;

    private final ClusterNetwork network;
    private final String release;
    private final AssetTransfer assetTransfer;
    private final ShotRelighter relighter;
    private final RejectedPeers rejectedPeers;
    private final ScheduledExecutorService timer = Executors.newSingleThreadScheduledExecutor(DedicatedThread.factory("lightning-hello"));
    /** Sessions offered and not accepted yet, by member. */
    private final Map<ClusterMember, UUID> offeredSessions = new HashMap<>();
    private final Map<ClusterMember, ActiveNode> activeNodes = new HashMap<>();
    /** Time to join again unless a node appears before. */
    private long rejoinAt = System.nanoTime() + REJOIN_NANOSECONDS;

    /** Connected node, with the time of its last message. */
    private static final class ActiveNode {
        private final UUID id;
        private final RemoteFrameHost host;
        private volatile long lastHeard = System.nanoTime();

        ActiveNode(UUID id, RemoteFrameHost host) {
            this.id = id;
            this.host = host;
        }
    }

    /**
     * @param release this program's release; only nodes of the same release are used
     * @param folder  folder of the scene file, for files that it names
     * @param shot    receives each node as a host
     * @param log     receives messages for the user
     */
    public NodePool(ClusterNetwork network, String release, Path folder, ShotRelighter shot, Consumer<String> log) {
        this.network = network;
        this.release = release;
        this.relighter = shot;
        assetTransfer = new AssetTransfer(folder);
        rejectedPeers = new RejectedPeers(network, log);
    }

    /** Joins the cluster. */
    public void start() throws JoinException {
        network.join(this);
        timer.scheduleWithFixedDelay(this::checkNodes, HELLO_MILLISECONDS, HELLO_MILLISECONDS, TimeUnit.MILLISECONDS);
    }

    /** Offers sessions again to members that did not answer; some are not nodes and never answer. */
    private void offerSessions() {
        Map<ClusterMember, UUID> unanswered;
        synchronized (this) {
            unanswered = Map.copyOf(offeredSessions);
        }
        unanswered.forEach((member, id) -> network.send(member, MessageCodec.encode(new Message.OpenSession(id, release))));
    }

    /** Sends heartbeats to connected nodes; joins again after a long time without nodes. */
    private void checkNodes() {
        Map<ClusterMember, ActiveNode> nodes;
        synchronized (this) {
            nodes = Map.copyOf(activeNodes);
        }
        if (isRejoinDue(!nodes.isEmpty())) {
            network.rejoin();
        }
        nodes.forEach((member, node) -> {
            if (System.nanoTime() - node.lastHeard > SILENCE_TIMEOUT_NANOSECONDS) {
                drop(member, node);
            } else {
                network.send(member, MessageCodec.encode(new Message.Heartbeat(node.id)));
            }
        });
        offerSessions();
    }

    private synchronized boolean isRejoinDue(boolean hasNodes) {
        long now = System.nanoTime();
        boolean due = !hasNodes && now - rejoinAt > 0;
        if (hasNodes || due) {
            rejoinAt = now + REJOIN_NANOSECONDS;
        }
        return due;
    }

    /** Drops a node with its frames and offers it a new session. */
    private void drop(ClusterMember member, ActiveNode node) {
        synchronized (this) {
            if (!activeNodes.remove(member, node)) {
                return;
            }
            offeredSessions.put(member, UUID.randomUUID());
        }
        relighter.removeHost(node.host, node.host.disconnect());
    }

    @Override
    public void membersChanged(Set<ClusterMember> others) {
        List<RemoteFrameHost> lostHosts = new ArrayList<>();
        synchronized (this) {
            long answerDeadline = System.nanoTime() + ANSWER_TIMEOUT_NANOSECONDS;
            if (!others.isEmpty() && answerDeadline - rejoinAt > 0) {
                rejoinAt = answerDeadline;
            }
            offeredSessions.keySet().retainAll(others);
            for (ClusterMember lost : new HashSet<>(activeNodes.keySet())) {
                if (!others.contains(lost)) {
                    lostHosts.add(requireNonNull(activeNodes.remove(lost)).host);
                }
            }
            for (ClusterMember other : others) {
                if (!activeNodes.containsKey(other)) {
                    offeredSessions.computeIfAbsent(other, _ -> UUID.randomUUID());
                }
            }
        }
        for (RemoteFrameHost host : lostHosts) {
            relighter.removeHost(host, host.disconnect());
        }
        offerSessions();
    }

    /** Returns the number of nodes. */
    public synchronized int count() {
        return activeNodes.size();
    }

    @Override
    public void messageReceived(ClusterMember from, byte[] bytes) {
        try {
            Message message = MessageCodec.decode(bytes);
            if (message instanceof Message.SessionOpened opened) {
                addNode(from, opened);
            } else {
                activeNode(from, message.session()).ifPresent(node -> handle(from, node, message));
            }
        } catch (WireException e) {
            rejectedPeers.report(from, e);
        }
    }

    private void handle(ClusterMember from, ActiveNode node, Message message) {
        node.lastHeard = System.nanoTime();
        if (message instanceof Message.CloseSession) {
            drop(from, node);
        } else {
            node.host.handle(message);
        }
    }

    private void addNode(ClusterMember from, Message.SessionOpened opened) {
        if (!opened.release().equals(release)) {
            rejectedPeers.report(from, Messages.tr("it runs {0}, this machine {1}", opened.release(), release));
            return;
        }
        RemoteFrameHost host;
        synchronized (this) {
            if (!offeredSessions.remove(from, opened.session())) {
                return;
            }
            UUID id = opened.session();
            host = new RemoteFrameHost(id, network.addressOf(from), assetTransfer,
                    message -> network.send(from, MessageCodec.encode(message)));
            activeNodes.put(from, new ActiveNode(id, host));
        }
        relighter.addHost(host);
    }

    /** Returns the node of an active session. */
    private synchronized Optional<ActiveNode> activeNode(ClusterMember from, UUID session) {
        return Optional.ofNullable(activeNodes.get(from)).filter(h -> h.id.equals(session));
    }

    @Override
    public void close() {
        timer.shutdownNow();
        network.close();
    }
}
