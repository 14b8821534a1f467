package lightning.shot.cluster;

import java.io.IOException;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import lightning.base.work.OwnThread;
import lightning.base.work.Progress;
import lightning.format.jen.JenException;
import lightning.render.image.Downscale;
import lightning.render.image.Film;
import lightning.render.relight.PictureTooLarge;
import lightning.shot.FrameKeeper;
import lightning.shot.FrameRefusedException;
import lightning.shot.FrameUpdate;
import lightning.shot.KeeperGoneException;
import lightning.shot.KeptBytes;
import lightning.shot.cluster.wire.Hash;
import lightning.shot.cluster.wire.Message;
import lightning.shot.cluster.wire.WireException;

/** One coordinator's frames at a node. */
final class NodeSession implements AutoCloseable {
    /** Wishes at once: a coordinator has two, and one more of each frame that it no longer wanted. */
    private static final int MOST_CALLS = 8;
    /** Answers that are kept, to be given again. */
    private static final int MOST_ANSWERS = 64;

    final Member owner;
    private final UUID id;
    private final FrameKeeper keeper;
    private final Consumer<Message> send;
    private final TakeReader reader;
    private final Asker<Place, byte[]> asker = new Asker<>();
    private final ExecutorService work = Executors.newCachedThreadPool(OwnThread.named("lightning-node"));
    private final ExecutorService films = OwnThread.inTurn("lightning-films");
    private final Map<Long, AtomicBoolean> running = new HashMap<>();
    private final Map<Long, Message> answers = new LinkedHashMap<>();
    /** By frame, the newest wish. */
    private final Map<Integer, Long> wanted = new HashMap<>();
    /** By frame, whose film is kept. */
    private final Map<Integer, Long> shown = new HashMap<>();
    /** By frame: one wish at a time works with it. */
    private final Map<Integer, Object> locks = new HashMap<>();
    private long filmCall = -1;
    private Film film;

    private record Place(Hash hash, long offset) {}

    NodeSession(Member owner, UUID id, FrameKeeper keeper, ContentFolder contents, Consumer<Message> send) {
        this.owner = owner;
        this.id = id;
        this.keeper = keeper;
        this.send = send;
        reader = new TakeReader(contents, (hash, offset) -> asker.ask(new Place(hash, offset),
                () -> send.accept(new Message.Need(id, hash, offset)), () -> false));
    }

    void part(Message.Part part) {
        asker.answered(new Place(part.hash(), part.offset()), part.bytes());
    }

    synchronized void bring(Message.Bring wish) {
        Message answer = answers.get(wish.call());
        if (answer != null) {
            send.accept(answer);
        } else if (!running.containsKey(wish.call()) && running.size() < MOST_CALLS) {
            var cancelled = new AtomicBoolean();
            running.put(wish.call(), cancelled);
            wanted.merge(wish.frame(), wish.call(), Math::max);
            execute(work, () -> answer(wish.call(), attempt(wish, cancelled)));
        }
    }

    private static void execute(ExecutorService threads, Runnable task) {
        try {
            threads.execute(task);
        } catch (RejectedExecutionException e) {
            // Closed meanwhile.
        }
    }

    private void answer(long call, Message answer) {
        synchronized (this) {
            running.remove(call);
            answers.put(call, answer);
            if (answers.size() > MOST_ANSWERS) {
                answers.remove(answers.keySet().iterator().next());
            }
        }
        send.accept(answer);
    }

    private Message attempt(Message.Bring wish, AtomicBoolean cancelled) {
        try {
            return made(wish, cancelled);
        } catch (CancellationException e) {
            return failed(wish, Message.Reason.CANCELLED, "");
        } catch (PictureTooLarge e) {
            forget(wish.frame());
            return failed(wish, Message.Reason.REFUSED, e.getMessage());
        } catch (OutOfMemoryError e) {
            forget(wish.frame());
            return failed(wish, Message.Reason.REFUSED, "it has not enough memory");
        } catch (ContentException | WireException | JenException | IllegalArgumentException | KeeperGoneException e) {
            return failed(wish, Message.Reason.UNUSABLE, String.valueOf(e.getMessage()));
        } catch (FrameRefusedException | IOException e) {
            return failed(wish, Message.Reason.REFUSED, String.valueOf(e.getMessage()));
        } catch (RuntimeException | Error e) {
            return failed(wish, Message.Reason.ERROR, e.toString());
        }
    }

    private Message failed(Message.Bring wish, Message.Reason reason, String sentence) {
        return new Message.Failed(id, wish.call(), reason, sentence);
    }

    private Message made(Message.Bring wish, AtomicBoolean cancelled)
            throws IOException, WireException, JenException, KeeperGoneException {
        var take = reader.take(wish.bill(), wish.billBytes());
        synchronized (lock(wish.frame())) {
            if (isOutdated(wish)) {
                throw new CancellationException();
            }
            FrameUpdate update = keeper.bring(wish.frame(), take, Progress.until(cancelled::get));
            synchronized (this) {
                shown.put(wish.frame(), wish.call());
            }
            Film made = update.film();
            KeptBytes bytes = keeper.bytes();
            return new Message.Brought(id, wish.call(), update.traced(), update.plan(), update.rays(), update.nanoseconds(), made.width(),
                    made.height(), bytes.memory(), bytes.disk());
        }
    }

    private synchronized Object lock(int frame) {
        return locks.computeIfAbsent(frame, _ -> new Object());
    }

    private synchronized boolean isOutdated(Message.Bring wish) {
        return wanted.get(wish.frame()) != wish.call();
    }

    synchronized void cancel(long call) {
        AtomicBoolean cancelled = running.get(call);
        if (cancelled != null) {
            cancelled.set(true);
        }
    }

    void ask(Message.Ask ask) {
        execute(films, () -> {
            byte[] bytes = film(ask).map(f -> FilmTiles.encode(small(f, ask), ask.firstTile(), ask.tiles())).orElse(new byte[0]);
            send.accept(bytes.length == 0 ? new Message.Gone(id, ask.call(), ask.frame())
                    : new Message.Pixels(id, ask.call(), ask.frame(), ask.mostWidth(), ask.mostHeight(), ask.firstTile(), bytes));
        });
    }

    private static Film small(Film film, Message.Ask ask) {
        return Downscale.into(film.width(), film.height(), Math.max(1, ask.mostWidth()), Math.max(1, ask.mostHeight())).of(film);
    }

    /** On the one thread of films, which keeps the last: its tiles are asked for one after the other. */
    private Optional<Film> film(Message.Ask ask) {
        if (filmCall == ask.call()) {
            return Optional.of(film);
        }
        synchronized (lock(ask.frame())) {
            synchronized (this) {
                if (!shown.getOrDefault(ask.frame(), -1L).equals(ask.call())) {
                    return Optional.empty();
                }
            }
            Optional<Film> kept = keeper.film(ask.frame());
            kept.ifPresent(f -> {
                film = f;
                filmCall = ask.call();
            });
            return kept;
        }
    }

    void focus(int frame) {
        keeper.focus(frame);
    }

    void forget(int frame) {
        synchronized (this) {
            shown.remove(frame);
        }
        keeper.forget(frame);
    }

    /** Stops all that is under way; drops all frames, beside the caller. */
    @Override
    public void close() {
        asker.close();
        synchronized (this) {
            running.values().forEach(cancelled -> cancelled.set(true));
        }
        films.shutdownNow();
        work.execute(() -> awaitCalls());
        work.shutdown();
    }

    private void awaitCalls() {
        try {
            while (isWorking()) {
                Thread.sleep(10);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            keeper.close();
        }
    }

    private synchronized boolean isWorking() {
        return !running.isEmpty();
    }
}
