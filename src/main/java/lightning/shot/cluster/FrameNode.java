package lightning.shot.cluster;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import lightning.shot.FrameKeeper;
import lightning.shot.cluster.wire.Codec;
import lightning.shot.cluster.wire.Message;
import lightning.shot.cluster.wire.WireException;

/** Holds frames for coordinators of its cluster, as long as these are members. */
public final class FrameNode implements Network.Listener, AutoCloseable {
    /** Coordinators at once; others wait for one to end. */
    public static final int MOST_SESSIONS = 2;

    private final Network network;
    private final Settings settings;
    private final ContentFolder contents;
    private final Map<UUID, NodeSession> sessions = new ConcurrentHashMap<>();
    private final Strangers strangers;
    private boolean closed;

    /**
     * How a node holds frames.
     *
     * @param release of this program: only machines of the same one go together
     * @param folder  its own, for content; what is in it is removed
     * @param keeper  what holds the frames of a new session
     * @param log     gets a sentence at times
     */
    public record Settings(String release, int threads, long memory, Path folder, Keepers keeper, Consumer<String> log) {}

    /** Makes what holds the frames of a session. */
    @FunctionalInterface
    public interface Keepers {
        /** @throws IOException if it finds no room */
        FrameKeeper next() throws IOException;
    }

    /** @throws IOException if the folder cannot be used */
    public FrameNode(Network network, Settings settings) throws IOException {
        this.network = network;
        this.settings = settings;
        contents = new ContentFolder(settings.folder());
        strangers = new Strangers(network, settings.log());
    }

    /** Takes part from here on. */
    public void start() throws JoinException {
        network.join(this);
    }

    @Override
    public void heard(Member from, byte[] bytes) {
        try {
            heard(from, Codec.decode(bytes));
        } catch (WireException e) {
            strangers.tell(from, e);
        }
    }

    private void heard(Member from, Message message) {
        if (message instanceof Message.Hello hello) {
            welcome(from, hello);
            return;
        }
        NodeSession session = sessions.get(message.session());
        if (session == null && !(message instanceof Message.End)) {
            // It was ended while the two did not see each other, and only this one noticed.
            network.send(from, Codec.encode(new Message.End(message.session())));
        }
        if (session == null || !session.owner.equals(from)) {
            return;
        }
        switch (message) {
            case Message.Bring m -> session.bring(m);
            case Message.Cancel m -> session.cancel(m.call());
            case Message.Part m -> session.part(m);
            case Message.Ask m -> session.ask(m);
            case Message.Focus m -> session.focus(m.frame());
            case Message.Forget m -> session.forget(m.frame());
            case Message.End m -> end(m.session());
            case Message.Alive m -> network.send(from, Codec.encode(m));
            case Message.Hello _,Message.Ready _,Message.Brought _,Message.Failed _,Message.Need _,Message.Pixels _,Message.Gone _ -> {
                // Not for a node.
            }
        }
    }

    private void welcome(Member from, Message.Hello hello) {
        if (!hello.release().equals(settings.release())) {
            strangers.tell(from, "it runs " + hello.release() + ", this node " + settings.release());
        } else if (!sessions.containsKey(hello.session()) && !begin(from, hello.session())) {
            return;
        }
        // One of another release is told ours all the same, so that it can say why.
        network.send(from, Codec.encode(new Message.Ready(hello.session(), settings.release(), settings.threads(), settings.memory())));
    }

    private synchronized boolean begin(Member from, UUID id) {
        // One that offers a new session has given up its old one, of which this node may not have heard.
        sessions.forEach((old, session) -> {
            if (session.owner.equals(from)) {
                end(old);
            }
        });
        if (closed || sessions.size() == MOST_SESSIONS) {
            return false;
        }
        try {
            sessions.put(id, new NodeSession(from, id, settings.keeper().next(), contents,
                    message -> network.send(from, Codec.encode(message))));
            settings.log().accept("holds frames for " + network.name(from));
            return true;
        } catch (IOException e) {
            strangers.tell(from, "there is no room for its frames: " + e.getMessage());
            return false;
        }
    }

    private void end(UUID id) {
        NodeSession ended = sessions.remove(id);
        if (ended != null) {
            settings.log().accept("holds no more frames for " + network.name(ended.owner));
            ended.close();
        }
    }

    @Override
    public void changed(Set<Member> others) {
        sessions.forEach((id, session) -> {
            if (!others.contains(session.owner)) {
                end(id);
            }
        });
    }

    @Override
    public void close() {
        network.close();
        synchronized (this) {
            // What was on its way may still be heard.
            closed = true;
            sessions.values().forEach(NodeSession::close);
            sessions.clear();
        }
        contents.clear();
    }
}
