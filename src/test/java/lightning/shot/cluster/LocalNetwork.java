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

/** In-process network whose messages can be lost and whose connections can be cut. */
final class LocalNetwork {
    private final Map<ClusterMember, Endpoint> endpoints = new LinkedHashMap<>();
    private final Set<ClusterMember> disconnected = new HashSet<>();
    private final Random random;
    private final double lossRate;

    /** @param lost fraction of messages that never arrive */
    LocalNetwork(long seed, double lost) {
        random = new Random(seed);
        this.lossRate = lost;
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
        Endpoint end = endpoints.get(to);
        if (end != null && endpoints.containsKey(from.self) && canReach(from.self, to) && random.nextDouble() >= lossRate) {
            end.inbox.execute(() -> end.listener.messageReceived(from.self, bytes));
        }
    }

    /** One member. */
    final class Endpoint implements ClusterNetwork {
        private final ClusterMember self;
        private final ExecutorService inbox = Executors.newSingleThreadExecutor();
        private Listener listener;

        private Endpoint(ClusterMember self) {
            this.self = self;
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
        }
    }
}
