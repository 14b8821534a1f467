package lightning.shot.cluster;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import lightning.base.text.Messages;
import lightning.base.text.RefusalException;
import lightning.base.work.Progress;
import lightning.render.image.Downscale;
import lightning.render.image.Film;
import lightning.shot.CacheUsage;
import lightning.shot.FrameHost;
import lightning.shot.FrameRejectedException;
import lightning.shot.FrameUpdate;
import lightning.shot.HostLostException;
import lightning.shot.ShotRevision;
import lightning.shot.cluster.wire.Message;
import org.jspecify.annotations.Nullable;

/** Frame host on a remote node, as seen by the coordinator. */
final class RemoteFrameHost implements FrameHost {
    private final UUID id;
    private final String name;
    private final AssetTransfer assetTransfer;
    private final Consumer<Message> send;
    private final ContentSender contentSender;
    private final PartSize tileBytes = new PartSize();
    private final AtomicLong calls = new AtomicLong();
    private final PendingRequests<Long, Message> updateRequests = new PendingRequests<>();
    private final PendingRequests<TileRange, byte[]> tileRequests = new PendingRequests<>();
    private final Map<Integer, Message.FrameUpdated> updates = new ConcurrentHashMap<>();
    private volatile CacheUsage usage = CacheUsage.NONE;

    private record TileRange(long call, int maxWidth, int maxHeight, int firstTile) {}

    /**
     * @param name the node's name for the user
     * @param send sends a message to the node
     */
    RemoteFrameHost(UUID id, String name, AssetTransfer assets, Consumer<Message> send) {
        this.id = id;
        this.name = name;
        this.assetTransfer = assets;
        this.send = send;
        contentSender = new ContentSender(assets, send);
    }

    @Override
    public FrameUpdate update(int frame, ShotRevision revision, Progress progress) throws HostLostException {
        long start = System.nanoTime();
        AssetTransfer.Transfer transfer = prepare(revision);
        long call = calls.incrementAndGet();
        var request = new Message.UpdateFrame(id, call, frame, transfer.hash(), transfer.manifest().length);
        Message answer;
        try {
            answer = updateRequests.request(call, () -> send.accept(request), progress::isCanceled);
        } catch (CancellationException e) {
            if (updateRequests.isClosed()) {
                throw lost(e);
            }
            send.accept(new Message.CancelUpdate(id, call));
            throw e;
        }
        return switch (answer) {
            case Message.FrameUpdated updated -> {
                updates.put(frame, updated);
                usage = new CacheUsage(updates.size(), updated.memory(), 0, updated.disk());
                yield new FrameUpdate(frame, updated.traced(), updated.plan(), updated.rays(), System.nanoTime() - start,
                        () -> film(frame, updated, updated.width(), updated.height()).orElseThrow(CancellationException::new));
            }
            case Message.UpdateFailed failed -> {
                if (failed.reason() == Message.FailureReason.REJECTED) {
                    updates.remove(frame);
                }
                throw failure(failed);
            }
            default -> throw new IllegalStateException("unexpected answer: " + answer);
        };
    }

    private AssetTransfer.Transfer prepare(ShotRevision revision) {
        try {
            return assetTransfer.prepare(revision);
        } catch (IOException e) {
            throw new RefusalException(String.valueOf(e.getMessage()), e);
        }
    }

    private RuntimeException failure(Message.UpdateFailed failed) {
        // The node's message is in its own language.
        String message = Messages.tr("node {0}: {1}", name, failed.message());
        return switch (failed.reason()) {
            case CANCELED -> new CancellationException();
            case INVALID -> new RefusalException(message);
            case REJECTED -> new FrameRejectedException(message);
            case ERROR -> new IllegalStateException(message);
        };
    }

    @Override
    public Optional<Film> film(int frame) {
        return Optional.ofNullable(updates.get(frame)).flatMap(update -> film(frame, update, update.width(), update.height()));
    }

    /** Downscales on the node, to save bandwidth. */
    @Override
    public Optional<Film> film(int frame, int maxWidth, int maxHeight) {
        return Optional.ofNullable(updates.get(frame)).flatMap(update -> film(frame, update, maxWidth, maxHeight));
    }

    /** Fetches the film of an answer; empty if it is gone. */
    private Optional<Film> film(int frame, Message.FrameUpdated update, int maxWidth, int maxHeight) {
        Downscale size = Downscale.fit(update.width(), update.height(), maxWidth, maxHeight);
        Film film = Film.black(size.width(), size.height());
        try {
            int count;
            for (int first = 0; first < film.tileCount(); first += count) {
                count = Math.clamp(tileBytes.bytes() / FilmTiles.TILE_BYTES, 1, film.tileCount() - first);
                if (!FilmTiles.decode(requestTiles(frame, update.call(), maxWidth, maxHeight, first, count), film, first, count)) {
                    return Optional.empty();
                }
            }
            return Optional.of(film);
        } catch (CancellationException e) {
            return Optional.empty();
        }
    }

    private byte[] requestTiles(int frame, long call, int maxWidth, int maxHeight, int first, int count) {
        long start = System.nanoTime();
        byte[] tiles = tileRequests.request(new TileRange(call, maxWidth, maxHeight, first),
                () -> send.accept(new Message.RequestTiles(id, call, frame, maxWidth, maxHeight, first, count)),
                Thread.currentThread()::isInterrupted);
        tileBytes.adapt(tiles.length + FilmTiles.TILE_BYTES, System.nanoTime() - start);
        return tiles;
    }

    void handle(Message message) {
        switch (message) {
            case Message.FrameUpdated m -> updateRequests.complete(m.call(), m);
            case Message.UpdateFailed m -> updateRequests.complete(m.call(), m);
            case Message.RequestContent m -> contentSender.request(m);
            case Message.FilmTileData m ->
                    tileRequests.complete(new TileRange(m.call(), m.maxWidth(), m.maxHeight(), m.firstTile()), m.bytes());
            case Message.FilmUnavailable m -> tileRequests.completeAll(piece -> piece.call() == m.call(), new byte[0]);
            case Message.OpenSession _,Message.SessionOpened _,Message.UpdateFrame _,Message.CancelUpdate _,Message.ContentPart _,Message.RequestTiles _,Message.FocusFrame _,Message.DropFrame _,Message.CloseSession _,Message.Heartbeat _ -> {
                // Not for a coordinator.
            }
        }
    }

    /** Marks the node as lost; waiting callers fail. */
    HostLostException disconnect() {
        contentSender.close();
        updateRequests.close();
        tileRequests.close();
        return lost(null);
    }

    private HostLostException lost(@Nullable Throwable cause) {
        return new HostLostException(Messages.tr("lost node {0}; its frames are being rendered on other nodes", name), cause);
    }

    @Override
    public void focus(int frame) {
        send.accept(new Message.FocusFrame(id, frame));
    }

    @Override
    public void drop(int frame) {
        updates.remove(frame);
        send.accept(new Message.DropFrame(id, frame));
    }

    @Override
    public CacheUsage usage() {
        return usage;
    }

    @Override
    public void close() {
        disconnect();
        send.accept(new Message.CloseSession(id));
    }
}
