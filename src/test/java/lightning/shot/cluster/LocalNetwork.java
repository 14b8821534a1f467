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

/** Members in one process, whose messages can be lost and whose connections can be cut. */
final class LocalNetwork {
    private final Map<Member, End> ends = new LinkedHashMap<>();
    private final Set<Member> cut = new HashSet<>();
    private final Random random;
    private final double lost;

    /** @param lost the share of messages that never arrives */
    LocalNetwork(long seed, double lost) {
        random = new Random(seed);
        this.lost = lost;
    }

    End end() {
        return new End(new Member(UUID.randomUUID()));
    }

    /** Cuts a member from all others, or gives it back to them. */
    synchronized void cut(End end, boolean is) {
        if (is ? cut.add(end.self) : cut.remove(end.self)) {
            tell();
        }
    }

    private synchronized void add(End end) {
        ends.put(end.self, end);
        tell();
    }

    private synchronized void remove(End end) {
        ends.remove(end.self);
        tell();
    }

    private void tell() {
        for (End end : new ArrayList<>(ends.values())) {
            Set<Member> others = new HashSet<>(ends.keySet());
            others.removeIf(other -> other.equals(end.self) || !reach(end.self, other));
            end.inbox.execute(() -> end.listener.changed(Set.copyOf(others)));
        }
    }

    private boolean reach(Member a, Member b) {
        return !cut.contains(a) && !cut.contains(b);
    }

    private synchronized void deliver(End from, Member to, byte[] bytes) {
        End end = ends.get(to);
        if (end != null && ends.containsKey(from.self) && reach(from.self, to) && random.nextDouble() >= lost) {
            end.inbox.execute(() -> end.listener.heard(from.self, bytes));
        }
    }

    /** One member. */
    final class End implements Network {
        private final Member self;
        private final ExecutorService inbox = Executors.newSingleThreadExecutor();
        private Listener listener;

        private End(Member self) {
            this.self = self;
        }

        @Override
        public void join(Listener heard) {
            listener = heard;
            add(this);
        }

        @Override
        public void send(Member to, byte[] bytes) {
            deliver(this, to, bytes);
        }

        @Override
        public void rejoin() {
            // Whoever is not cut is seen.
        }

        @Override
        public String name(Member member) {
            synchronized (LocalNetwork.this) {
                return "member " + List.copyOf(ends.keySet()).indexOf(member);
            }
        }

        @Override
        public void close() {
            remove(this);
            inbox.shutdown();
        }
    }
}
