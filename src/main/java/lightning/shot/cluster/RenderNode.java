package lightning.shot.cluster;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import lightning.shot.FrameHost;
import lightning.shot.cluster.wire.Message;
import lightning.shot.cluster.wire.MessageCodec;
import lightning.shot.cluster.wire.WireException;

/** Render node: renders and caches frames for the coordinators of its cluster. */
public final class RenderNode implements ClusterNetwork.Listener, AutoCloseable {
    /** Maximum number of coordinators; others wait until one leaves. */
    public static final int MAX_SESSIONS = 2;

    private final ClusterNetwork network;
    private final Settings settings;
    private final ContentFolder contents;
    private final Map<UUID, NodeSession> sessions = new ConcurrentHashMap<>();
    private final RejectedPeers rejectedPeers;
    private boolean closed;

    /**
     * Settings of a node.
     *
     * @param release this program's release; only machines of the same release work together
     * @param folder  private folder for content; existing files in it are removed
     * @param hosts   factory of a new session's frame host
     * @param log     receives messages for the user
     */
    public record Settings(String release, int threads, long memory, Path folder, HostFactory hosts, Consumer<String> log) {}

    /** Factory for the frame host of a session. */
    @FunctionalInterface
    public interface HostFactory {
        /** @throws IOException if there is not enough space */
        FrameHost create() throws IOException;
    }

    /** @throws IOException if the folder cannot be used */
    public RenderNode(ClusterNetwork network, Settings settings) throws IOException {
        this.network = network;
        this.settings = settings;
        contents = new ContentFolder(settings.folder());
        rejectedPeers = new RejectedPeers(network, settings.log());
    }

    /** Joins the cluster. */
    public void start() throws JoinException {
        network.join(this);
    }

    @Override
    public void messageReceived(ClusterMember from, byte[] bytes) {
        try {
            handle(from, MessageCodec.decode(bytes));
        } catch (WireException e) {
            rejectedPeers.report(from, e);
        }
    }

    private void handle(ClusterMember from, Message message) {
        if (message instanceof Message.OpenSession offer) {
            acceptSession(from, offer);
            return;
        }
        NodeSession session = sessions.get(message.session());
        if (session == null && !(message instanceof Message.CloseSession)) {
            // The session ended while the two were separated, and only this node noticed.
            network.send(from, MessageCodec.encode(new Message.CloseSession(message.session())));
        }
        if (session == null || !session.owner.equals(from)) {
            return;
        }
        switch (message) {
            case Message.UpdateFrame m -> session.updateFrame(m);
            case Message.CancelUpdate m -> session.cancel(m.call());
            case Message.ContentPart m -> session.contentReceived(m);
            case Message.RequestTiles m -> session.sendTiles(m);
            case Message.FocusFrame m -> session.setFocus(m.frame());
            case Message.DropFrame m -> session.drop(m.frame());
            case Message.CloseSession m -> closeSession(m.session());
            case Message.Heartbeat m -> network.send(from, MessageCodec.encode(m));
            case Message.OpenSession _,Message.SessionOpened _,Message.FrameUpdated _,Message.UpdateFailed _,Message.RequestContent _,Message.FilmTileData _,Message.FilmUnavailable _ -> {
                // Not for a node.
            }
        }
    }

    private void acceptSession(ClusterMember from, Message.OpenSession offer) {
        if (!offer.release().equals(settings.release())) {
            rejectedPeers.report(from, "it runs " + offer.release() + ", this node " + settings.release());
        } else if (!sessions.containsKey(offer.session()) && !openSession(from, offer.session())) {
            return;
        }
        // Sends our release even to a member of another one, so that it can report the difference.
        network.send(from,
                MessageCodec.encode(new Message.SessionOpened(offer.session(), settings.release(), settings.threads(), settings.memory())));
    }

    private synchronized boolean openSession(ClusterMember from, UUID id) {
        // A member that offers a new session has dropped its old one, possibly unnoticed by this node.
        sessions.forEach((oldId, session) -> {
            if (session.owner.equals(from)) {
                closeSession(oldId);
            }
        });
        if (closed || sessions.size() == MAX_SESSIONS) {
            return false;
        }
        try {
            sessions.put(id, new NodeSession(from, id, settings.hosts().create(), contents,
                    message -> network.send(from, MessageCodec.encode(message))));
            settings.log().accept("rendering for " + network.addressOf(from));
            return true;
        } catch (IOException e) {
            rejectedPeers.report(from, "cannot store its frames: " + e.getMessage());
            return false;
        }
    }

    private void closeSession(UUID id) {
        NodeSession session = sessions.remove(id);
        if (session != null) {
            settings.log().accept("finished rendering for " + network.addressOf(session.owner));
            session.close();
        }
    }

    @Override
    public void membersChanged(Set<ClusterMember> others) {
        sessions.forEach((id, session) -> {
            if (!others.contains(session.owner)) {
                closeSession(id);
            }
        });
    }

    @Override
    public void close() {
        network.close();
        synchronized (this) {
            // Messages in flight may still arrive.
            closed = true;
            sessions.values().forEach(NodeSession::close);
            sessions.clear();
        }
        contents.clear();
    }
}
