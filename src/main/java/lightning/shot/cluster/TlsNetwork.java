package lightning.shot.cluster;

import static java.util.Objects.requireNonNull;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.stream.Collectors;
import javax.net.ssl.SSLContext;
import lightning.base.text.Messages;
import org.jgroups.Address;
import org.jgroups.BytesMessage;
import org.jgroups.Event;
import org.jgroups.JChannel;
import org.jgroups.Message;
import org.jgroups.Receiver;
import org.jgroups.View;
import org.jgroups.logging.LogFactory;
import org.jgroups.protocols.FD_ALL3;
import org.jgroups.protocols.FRAG4;
import org.jgroups.protocols.MERGE3;
import org.jgroups.protocols.TCP;
import org.jgroups.protocols.TCPPING;
import org.jgroups.protocols.UFC;
import org.jgroups.protocols.UNICAST3;
import org.jgroups.protocols.VERIFY_SUSPECT2;
import org.jgroups.protocols.pbcast.GMS;
import org.jgroups.protocols.pbcast.NAKACK2;
import org.jgroups.protocols.pbcast.STABLE;
import org.jgroups.stack.DiagnosticsHandler;
import org.jgroups.util.DefaultSocketFactory;
import org.jgroups.util.DefaultThreadFactory;
import org.jgroups.util.UUID;
import org.jspecify.annotations.Nullable;

/** Cluster network over JGroups and TLS, with mutual authentication: all members present the same certificate. */
public final class TlsNetwork implements ClusterNetwork {
    /** Maximum bytes of a message on a connection; {@link FRAG4} splits larger ones. */
    private static final int MAX_BYTES = 1 << 18;
    private static final String CLUSTER = "lightning";
    private static final int URGENT_MAX_BYTES = 4096;
    private static final int HANDSHAKE_MILLISECONDS = 5000;
    /**
     * Attempts to join before starting a separate cluster. JGroups' default of 10 blocks for 20 s if the coordinator that it found has
     * gone.
     */
    private static final int JOIN_ATTEMPTS = 2;
    /** Timeout of a merge. A merge with an unresponsive member takes the whole time and is repeated. */
    private static final int MERGE_MILLISECONDS = 2000;
    /** Discovery requests within the join timeout. */
    private static final int DISCOVERY_RUNS = 4;

    private final NodeConfig config;
    private final ExecutorService inbox =
            Executors.newSingleThreadExecutor(Thread.ofPlatform().daemon().name("lightning-cluster").factory());
    private @Nullable JChannel channel;

    public TlsNetwork(NodeConfig config) {
        this.config = config;
    }

    @Override
    public void join(Listener listener) throws JoinException {
        SSLContext context = ClusterCertificate.sslContext(config.certificate());
        LogFactory.useNoopLogger(true);
        RestrictedMessageFactory.install();
        try {
            channel = new JChannel(transport(context), discoveryProtocol(), mergeProtocol(),
                    new FD_ALL3().setTimeout(config.timing().silence())
                            .setInterval(Math.max(1, config.timing().silence() / 4)),
                    suspectVerification(), multicastProtocol(), new UNICAST3(), new STABLE(),
                    membershipProtocol(), new UFC(), new FRAG4());
            channel.setReceiver(new MessageReceiver(listener));
            channel.connect(CLUSTER);
        } catch (Exception e) {
            close();
            throw new JoinException(Messages.tr("cannot join a cluster at {0}: {1}",
                    config.addressText(), reason(e)), e);
        }
    }

    /** Returns the innermost cause, because JGroups wraps it. */
    private static String reason(Throwable e) {
        Throwable inner = e;
        while (inner.getCause() != null) {
            inner = inner.getCause();
        }
        return inner.getMessage() == null ? inner.getClass().getSimpleName() : inner.getMessage();
    }

    private TCP transport(SSLContext context) throws Exception {
        TCP tcp = new TCP();
        tcp.setBindAddress(config.bind()).setBindPort(config.port()).setPortRange(config.ports() - 1);
        // The default handler would open its own port, without TLS.
        tcp.setDiagnosticsHandler(new DiagnosticsHandler(LogFactory.getLog(DiagnosticsHandler.class), new DefaultSocketFactory(),
                new DefaultThreadFactory("lightning-cluster", true)).setEnabled(false));
        tcp.setMaxLength(MAX_BYTES);
        tcp.tcpNodelay(true);
        // On a machine that renders with all processors, a handshake between two new processes takes seconds.
        tcp.setPeerAddrReadTimeout(HANDSHAKE_MILLISECONDS);
        tcp.setSockConnTimeout(HANDSHAKE_MILLISECONDS);
        // Detects a killed process when its connection closes.
        tcp.enableSuspectEvents(true);
        tcp.tls(new HandshakeTimeoutTls(context, HANDSHAKE_MILLISECONDS));
        return tcp;
    }

    private TCPPING discoveryProtocol() {
        List<InetSocketAddress> hosts =
                config.join().isEmpty() ? List.of(new InetSocketAddress(config.bind(), config.port())) : config.join();
        TCPPING ping = new TCPPING();
        ping.setInitialHosts(hosts);
        ping.setPortRange(0);
        // Members that each know only the first one learn each other's addresses from it. Otherwise a merged view is not stable: its
        // members cannot reach each other, suspect each other, and split again.
        ping.returnEntireCache(true);
        // A host that starts at the same moment may not listen yet: ask several times, without waiting for each.
        ping.numDiscoveryRuns(DISCOVERY_RUNS);
        ping.asyncDiscovery(true);
        ping.asyncDiscoveryUseSeparateThread(true);
        return ping;
    }

    private MERGE3 mergeProtocol() {
        long maxInterval = config.timing().merge();
        return new MERGE3().setMinInterval(Math.max(1, maxInterval / 4)).setMaxInterval(maxInterval).setCheckInterval(2 * maxInterval);
    }

    private VERIFY_SUSPECT2 suspectVerification() {
        return new VERIFY_SUSPECT2().setTimeout(config.timing().verify());
    }

    private static NAKACK2 multicastProtocol() {
        NAKACK2 multicasts = new NAKACK2();
        multicasts.useMcastXmit(false);
        return multicasts;
    }

    private GMS membershipProtocol() {
        GMS membership = new GMS();
        membership.setJoinTimeout(config.timing().join());
        membership.setMaxJoinAttempts(JOIN_ATTEMPTS);
        membership.setMergeTimeout(MERGE_MILLISECONDS);
        membership.printLocalAddress(false);
        return membership;
    }

    /** Forwards JGroups' events, on one thread. */
    private final class MessageReceiver implements Receiver {
        private final Listener listener;

        MessageReceiver(Listener listener) {
            this.listener = listener;
        }

        @Override
        public void receive(Message message) {
            if (!message.hasArray()) {
                return;
            }
            byte[] bytes = new byte[message.getLength()];
            System.arraycopy(message.getArray(), message.getOffset(), bytes, 0, bytes.length);
            ClusterMember from = member(message.getSrc());
            dispatch(() -> listener.messageReceived(from, bytes));
        }

        @Override
        public void viewAccepted(View view) {
            Address self = channel().getAddress();
            Set<ClusterMember> others =
                    view.getMembers().stream().filter(a -> !a.equals(self)).map(TlsNetwork::member).collect(Collectors.toUnmodifiableSet());
            dispatch(() -> listener.membersChanged(others));
        }

        private void dispatch(Runnable call) {
            try {
                inbox.execute(call);
            } catch (RejectedExecutionException e) {
                // Closed meanwhile.
            }
        }
    }

    private static ClusterMember member(Address address) {
        UUID id = (UUID) address;
        return new ClusterMember(new java.util.UUID(id.getMostSignificantBits(), id.getLeastSignificantBits()));
    }

    private static Address address(ClusterMember member) {
        return new UUID(member.id().getMostSignificantBits(), member.id().getLeastSignificantBits());
    }

    @Override
    public void send(ClusterMember to, byte[] bytes) {
        try {
            Address address = address(to);
            if (channel().getView().containsMember(address)) {
                BytesMessage message = new BytesMessage(address, bytes);
                if (bytes.length <= URGENT_MAX_BYTES) {
                    // Heartbeats bypass flow control, so that a flooded member can answer.
                    message.setFlag(Message.Flag.NO_FC);
                }
                channel().send(message);
            }
        } catch (Exception e) {
            // The member or this process left; a waiting caller retries, or fails when the loss is known.
        }
    }

    /** Returns the channel, once the cluster was joined. */
    private JChannel channel() {
        return requireNonNull(channel);
    }

    @Override
    public void rejoin() {
        try {
            channel().disconnect();
            channel().connect(CLUSTER);
        } catch (Exception e) {
            // The caller retries as long as it finds no members.
        }
    }

    @Override
    public String addressOf(ClusterMember member) {
        return String.valueOf(channel().<Object>down(new Event(Event.GET_PHYSICAL_ADDRESS, address(member))));
    }

    @Override
    public void close() {
        if (channel != null) {
            channel.close();
        }
        inbox.shutdown();
    }
}
