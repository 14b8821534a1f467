package lightning.shot.cluster;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Consumer;
import lightning.base.work.DedicatedThread;
import lightning.shot.cluster.wire.Message;
import lightning.shot.cluster.wire.MessageCodec;
import lightning.shot.cluster.wire.WireException;

/** In-process network whose messages can be lost and whose connections can be cut. */
final class LocalNetwork {
    private final Map<ClusterMember, Endpoint> endpoints = new LinkedHashMap<>();
    private final Set<ClusterMember> disconnected = new HashSet<>();
    private final Random random;
    private final double lossRate;
    private Consumer<byte[]> observer = _ -> {};

    /** @param lost fraction of messages that never arrive */
    LocalNetwork(long seed, double lost) {
        random = new Random(seed);
        this.lossRate = lost;
    }

    /** Sets a listener for all messages that are sent. */
    synchronized void observe(Consumer<byte[]> listener) {
        observer = listener;
    }

    static Message decode(byte[] bytes) {
        try {
            return MessageCodec.decode(bytes);
        } catch (WireException e) {
            throw new AssertionError(e);
        }
    }

    Endpoint addEndpoint() {
        return new Endpoint(new ClusterMember(UUID.randomUUID()));
    }

    /** Cuts a member off from all others, or reconnects it. */
    synchronized void setDisconnected(Endpoint end, boolean is) {
        if (is ? disconnected.add(end.self) : disconnected.remove(end.self)) {
            notifyMembers();
        }
    }

    private synchronized void add(Endpoint end) {
        endpoints.put(end.self, end);
        notifyMembers();
    }

    private synchronized void remove(Endpoint end) {
        endpoints.remove(end.self);
        notifyMembers();
    }

    private void notifyMembers() {
        for (Endpoint end : new ArrayList<>(endpoints.values())) {
            Set<ClusterMember> others = new HashSet<>(endpoints.keySet());
            others.removeIf(other -> other.equals(end.self) || !canReach(end.self, other));
            end.inbox.execute(() -> end.listener.membersChanged(Set.copyOf(others)));
        }
    }

    private boolean canReach(ClusterMember a, ClusterMember b) {
        return !disconnected.contains(a) && !disconnected.contains(b);
    }

    private synchronized void deliver(Endpoint from, ClusterMember to, byte[] bytes) {
        observer.accept(bytes);
        Endpoint end = endpoints.get(to);
        if (end != null && endpoints.containsKey(from.self) && canReach(from.self, to) && random.nextDouble() >= lossRate) {
            Runnable arrival = () -> end.inbox.execute(() -> end.listener.messageReceived(from.self, bytes));
            from.outgoing.carry(bytes.length, () -> end.incoming.carry(bytes.length, arrival));
        }
    }

    /** Wire that carries messages in order, immediately or at a limited rate. */
    private static final class Wire {
        private final ExecutorService thread = Executors.newSingleThreadExecutor(DedicatedThread.factory("wire"));
        private volatile double bytesPerSecond = Double.POSITIVE_INFINITY;

        void carry(int bytes, Runnable arrival) {
            if (bytesPerSecond == Double.POSITIVE_INFINITY) {
                arrival.run();
                return;
            }
            thread.execute(() -> {
                try {
                    Thread.sleep((long) (bytes * 1000 / bytesPerSecond));
                    arrival.run();
                } catch (InterruptedException | RejectedExecutionException e) {
                    // The receiver left.
                }
            });
        }
    }

    /** One member. */
    final class Endpoint implements ClusterNetwork {
        private final ClusterMember self;
        private final ExecutorService inbox = Executors.newSingleThreadExecutor();
        private final Wire outgoing = new Wire();
        private final Wire incoming = new Wire();
        private Listener listener;

        private Endpoint(ClusterMember self) {
            this.self = self;
        }

        /** Limits the rate of its link, in each direction. */
        void limit(double bytesPerSecond) {
            outgoing.bytesPerSecond = bytesPerSecond;
            incoming.bytesPerSecond = bytesPerSecond;
        }

        @Override
        public void join(Listener received) {
            listener = received;
            add(this);
        }

        @Override
        public void send(ClusterMember to, byte[] bytes) {
            deliver(this, to, bytes);
        }

        @Override
        public void rejoin() {
            // Connected members see each other.
        }

        @Override
        public String addressOf(ClusterMember member) {
            synchronized (LocalNetwork.this) {
                return "member " + List.copyOf(endpoints.keySet()).indexOf(member);
            }
        }

        @Override
        public void close() {
            remove(this);
            inbox.shutdown();
            outgoing.thread.shutdownNow();
            incoming.thread.shutdownNow();
        }
    }
}
