package lightning.shot.cluster;

import java.io.IOException;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import lightning.base.text.Texts;
import lightning.base.work.Progress;
import lightning.render.image.Downscale;
import lightning.render.image.Film;
import lightning.shot.FrameKeeper;
import lightning.shot.FrameRefusedException;
import lightning.shot.FrameUpdate;
import lightning.shot.KeeperGoneException;
import lightning.shot.KeptBytes;
import lightning.shot.Take;
import lightning.shot.cluster.wire.Message;

/** A node's frames, as those who want them see them. */
final class RemoteKeeper implements FrameKeeper {
    private final UUID id;
    private final String name;
    private final Parcels parcels;
    private final Consumer<Message> send;
    private final AtomicLong calls = new AtomicLong();
    private final Asker<Long, Message> wishes = new Asker<>();
    private final Asker<Piece, byte[]> films = new Asker<>();
    private final Map<Integer, Message.Brought> brought = new ConcurrentHashMap<>();
    private volatile KeptBytes bytes = KeptBytes.NONE;

    private record Piece(long call, int mostWidth, int mostHeight, int firstTile) {}

    /**
     * @param name what people call the node
     * @param send gives a message to the node
     */
    RemoteKeeper(UUID id, String name, Parcels parcels, Consumer<Message> send) {
        this.id = id;
        this.name = name;
        this.parcels = parcels;
        this.send = send;
    }

    @Override
    public FrameUpdate bring(int frame, Take take, Progress progress) throws KeeperGoneException {
        long start = System.nanoTime();
        Parcels.Parcel parcel = parcel(take);
        long call = calls.incrementAndGet();
        var wish = new Message.Bring(id, call, frame, parcel.hash(), parcel.bill().length);
        Message answer;
        try {
            answer = wishes.ask(call, () -> send.accept(wish), progress::isCancelled);
        } catch (CancellationException e) {
            if (wishes.isClosed()) {
                throw gone(e);
            }
            send.accept(new Message.Cancel(id, call));
            throw e;
        }
        return switch (answer) {
            case Message.Brought made -> {
                brought.put(frame, made);
                bytes = new KeptBytes(brought.size(), made.memory(), 0, made.disk());
                yield new FrameUpdate(frame, made.traced(), made.plan(), made.rays(), System.nanoTime() - start,
                        () -> film(frame, made, made.width(), made.height()).orElseThrow(CancellationException::new));
            }
            case Message.Failed failed -> {
                if (failed.reason() == Message.Reason.REFUSED) {
                    brought.remove(frame);
                }
                throw failure(failed);
            }
            default -> throw new IllegalStateException("an answer that is none: " + answer);
        };
    }

    private Parcels.Parcel parcel(Take take) {
        try {
            return parcels.of(take);
        } catch (IOException e) {
            throw new IllegalArgumentException(e.getMessage(), e);
        }
    }

    private RuntimeException failure(Message.Failed failed) {
        // What the node says is in its own language.
        String sentence = Texts.of("the node {0}: {1}", name, failed.sentence());
        return switch (failed.reason()) {
            case CANCELLED -> new CancellationException();
            case UNUSABLE -> new IllegalArgumentException(sentence);
            case REFUSED -> new FrameRefusedException(sentence);
            case ERROR -> new IllegalStateException(sentence);
        };
    }

    @Override
    public Optional<Film> film(int frame) {
        return Optional.ofNullable(brought.get(frame)).flatMap(made -> film(frame, made, made.width(), made.height()));
    }

    /** Made smaller by the node, so that little travels. */
    @Override
    public Optional<Film> film(int frame, int mostWidth, int mostHeight) {
        return Optional.ofNullable(brought.get(frame)).flatMap(made -> film(frame, made, mostWidth, mostHeight));
    }

    /** The film that an answer tells of; empty where it is there no more. */
    private Optional<Film> film(int frame, Message.Brought made, int mostWidth, int mostHeight) {
        Downscale size = Downscale.into(made.width(), made.height(), mostWidth, mostHeight);
        Film film = Film.black(size.width(), size.height());
        try {
            for (int first = 0; first < film.tileCount(); first += FilmTiles.MOST) {
                int from = first;
                int count = Math.min(FilmTiles.MOST, film.tileCount() - first);
                byte[] tiles = films.ask(new Piece(made.call(), mostWidth, mostHeight, first),
                        () -> send.accept(new Message.Ask(id, made.call(), frame, mostWidth, mostHeight, from, count)),
                        Thread.currentThread()::isInterrupted);
                if (!FilmTiles.decode(tiles, film, first, count)) {
                    return Optional.empty();
                }
            }
            return Optional.of(film);
        } catch (CancellationException e) {
            return Optional.empty();
        }
    }

    void heard(Message message) {
        switch (message) {
            case Message.Brought m -> wishes.answered(m.call(), m);
            case Message.Failed m -> wishes.answered(m.call(), m);
            case Message.Need m -> send.accept(new Message.Part(id, m.hash(), m.offset(), parcels.part(m.hash(), m.offset())));
            case Message.Pixels m -> films.answered(new Piece(m.call(), m.mostWidth(), m.mostHeight(), m.firstTile()), m.bytes());
            case Message.Gone m -> films.answeredAll(piece -> piece.call() == m.call(), new byte[0]);
            case Message.Hello _,Message.Ready _,Message.Bring _,Message.Cancel _,Message.Part _,Message.Ask _,Message.Focus _,Message.Forget _,Message.End _,Message.Alive _ -> {
                // Not for a coordinator.
            }
        }
    }

    /** The node is lost: whoever waits for it hears so. */
    KeeperGoneException leave() {
        wishes.close();
        films.close();
        return gone(null);
    }

    private KeeperGoneException gone(Throwable cause) {
        return new KeeperGoneException(Texts.of("the node {0} is there no more; others trace its frames again", name), cause);
    }

    @Override
    public void focus(int frame) {
        send.accept(new Message.Focus(id, frame));
    }

    @Override
    public void forget(int frame) {
        brought.remove(frame);
        send.accept(new Message.Forget(id, frame));
    }

    @Override
    public KeptBytes bytes() {
        return bytes;
    }

    @Override
    public void close() {
        leave();
        send.accept(new Message.End(id));
    }
}
