package lightning.shot.cluster;

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
import lightning.base.text.Texts;
import lightning.base.work.OwnThread;
import lightning.shot.RelitShot;
import lightning.shot.cluster.wire.Codec;
import lightning.shot.cluster.wire.Message;
import lightning.shot.cluster.wire.WireException;

/** The nodes of a cluster, as keepers of a shot: each that comes is handed out, each that is lost is told so. */
public final class Machines implements Network.Listener, AutoCloseable {
    private static final long HELLO_MILLISECONDS = 1000;
    /** A node that is a member but silent for so long counts as lost: the two may see different members. */
    private static final long SILENCE_NANOSECONDS = 20_000_000_000L;

    /** After so long without a node, which parts of a cluster need at most to find each other. */
    private static final long ALONE_NANOSECONDS = 15_000_000_000L;
    /** Others that were just seen have so long to answer before this process takes part anew. */
    private static final long ANSWER_NANOSECONDS = 5_000_000_000L;

    private final Network network;
    private final String release;
    private final Parcels parcels;
    private final RelitShot shot;
    private final Strangers strangers;
    private final ScheduledExecutorService timer = Executors.newSingleThreadScheduledExecutor(OwnThread.named("lightning-hello"));
    /** By member: sessions that were offered and not taken yet. */
    private final Map<Member, UUID> offered = new HashMap<>();
    private final Map<Member, Held> held = new HashMap<>();
    /** When to take part anew unless there is a node before. */
    private long rejoinAt = System.nanoTime() + ALONE_NANOSECONDS;

    /** A node in use, and when it was heard last. */
    private static final class Held {
        private final UUID id;
        private final RemoteKeeper keeper;
        private volatile long heard = System.nanoTime();

        Held(UUID id, RemoteKeeper keeper) {
            this.id = id;
            this.keeper = keeper;
        }
    }

    /**
     * @param release of this program: only nodes of the same one are used
     * @param folder  the folder that holds the scene file, for files that it names
     * @param shot    gets each node that comes as a keeper
     * @param log     gets a sentence at times
     */
    public Machines(Network network, String release, Path folder, RelitShot shot, Consumer<String> log) {
        this.network = network;
        this.release = release;
        this.shot = shot;
        parcels = new Parcels(folder);
        strangers = new Strangers(network, log);
    }

    /** Takes part from here on. */
    public void start() throws JoinException {
        network.join(this);
        timer.scheduleWithFixedDelay(this::look, HELLO_MILLISECONDS, HELLO_MILLISECONDS, TimeUnit.MILLISECONDS);
    }

    /** Asks again those who did not answer: some are no nodes, and never will. */
    private void hello() {
        Map<Member, UUID> unanswered;
        synchronized (this) {
            unanswered = Map.copyOf(offered);
        }
        unanswered.forEach((member, id) -> network.send(member, Codec.encode(new Message.Hello(id, release))));
    }

    /** Asks those in use for a sign of life; where there is none for long, takes part anew. */
    private void look() {
        Map<Member, Held> all;
        synchronized (this) {
            all = Map.copyOf(held);
        }
        if (isRejoinDue(!all.isEmpty())) {
            network.rejoin();
        }
        all.forEach((member, node) -> {
            if (System.nanoTime() - node.heard > SILENCE_NANOSECONDS) {
                drop(member, node);
            } else {
                network.send(member, Codec.encode(new Message.Alive(node.id)));
            }
        });
        hello();
    }

    private synchronized boolean isRejoinDue(boolean hasNodes) {
        long now = System.nanoTime();
        boolean due = !hasNodes && now - rejoinAt > 0;
        if (hasNodes || due) {
            rejoinAt = now + ALONE_NANOSECONDS;
        }
        return due;
    }

    /** What the node held is lost; another session is offered to it. */
    private void drop(Member member, Held node) {
        synchronized (this) {
            if (!held.remove(member, node)) {
                return;
            }
            offered.put(member, UUID.randomUUID());
        }
        shot.leave(node.keeper, node.keeper.leave());
    }

    @Override
    public void changed(Set<Member> others) {
        List<RemoteKeeper> gone = new ArrayList<>();
        synchronized (this) {
            long answered = System.nanoTime() + ANSWER_NANOSECONDS;
            if (!others.isEmpty() && answered - rejoinAt > 0) {
                rejoinAt = answered;
            }
            offered.keySet().retainAll(others);
            for (Member lost : new HashSet<>(held.keySet())) {
                if (!others.contains(lost)) {
                    gone.add(held.remove(lost).keeper);
                }
            }
            for (Member other : others) {
                if (!held.containsKey(other)) {
                    offered.computeIfAbsent(other, _ -> UUID.randomUUID());
                }
            }
        }
        for (RemoteKeeper keeper : gone) {
            shot.leave(keeper, keeper.leave());
        }
        hello();
    }

    /** How many nodes there are. */
    public synchronized int count() {
        return held.size();
    }

    @Override
    public void heard(Member from, byte[] bytes) {
        try {
            Message message = Codec.decode(bytes);
            if (message instanceof Message.Ready ready) {
                ready(from, ready);
            } else {
                held(from, message.session()).ifPresent(node -> heard(from, node, message));
            }
        } catch (WireException e) {
            strangers.tell(from, e);
        }
    }

    private void heard(Member from, Held node, Message message) {
        node.heard = System.nanoTime();
        if (message instanceof Message.End) {
            drop(from, node);
        } else {
            node.keeper.heard(message);
        }
    }

    private void ready(Member from, Message.Ready ready) {
        if (!ready.release().equals(release)) {
            strangers.tell(from, Texts.of("it runs {0}, this machine {1}", ready.release(), release));
            return;
        }
        RemoteKeeper keeper;
        synchronized (this) {
            if (!offered.remove(from, ready.session())) {
                return;
            }
            UUID id = ready.session();
            keeper = new RemoteKeeper(id, network.name(from), parcels, message -> network.send(from, Codec.encode(message)));
            held.put(from, new Held(id, keeper));
        }
        shot.join(keeper);
    }

    /** Where it is of a session in use. */
    private synchronized Optional<Held> held(Member from, UUID session) {
        return Optional.ofNullable(held.get(from)).filter(h -> h.id.equals(session));
    }

    @Override
    public void close() {
        timer.shutdownNow();
        network.close();
    }
}
