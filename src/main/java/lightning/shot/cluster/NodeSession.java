package lightning.shot.cluster;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import lightning.base.file.ContentHash;
import lightning.base.work.DedicatedThread;
import lightning.base.work.Progress;
import lightning.format.jen.JenException;
import lightning.render.image.Downscale;
import lightning.render.image.Film;
import lightning.render.relight.PictureTooLargeException;
import lightning.shot.CacheUsage;
import lightning.shot.FrameHost;
import lightning.shot.FrameRejectedException;
import lightning.shot.FrameUpdate;
import lightning.shot.HostLostException;
import lightning.shot.ShotRevision;
import lightning.shot.cluster.wire.Message;
import lightning.shot.cluster.wire.WireException;
import org.jspecify.annotations.Nullable;

/** Session of one coordinator at a node, with its frames. */
final class NodeSession implements AutoCloseable {
    /** Maximum concurrent requests: a coordinator has two, and one canceled request of each such frame. */
    private static final int MAX_CALLS = 8;
    /** Maximum number of answers kept for repeated requests. */
    private static final int MAX_ANSWERS = 64;

    final ClusterMember owner;
    private final UUID id;
    private final FrameHost host;
    private final Consumer<Message> send;
    private final RevisionReader reader;
    private final PendingRequests<ContentKey, byte[]> contentRequests = new PendingRequests<>();
    private final ExecutorService callExecutor = Executors.newCachedThreadPool(DedicatedThread.factory("lightning-node"));
    /**
     * Traces with low priority, so that a node with busy processors still answers. Only these threads: JGroups' virtual threads would
     * inherit the priority of a thread that wakes them.
     */
    private final ExecutorService tracingExecutor = Executors.newCachedThreadPool(DedicatedThread.lowPriorityFactory("lightning-tracing"));
    private final ExecutorService filmExecutor = DedicatedThread.sequentialExecutor("lightning-films");
    private final Map<Long, AtomicBoolean> runningCalls = new HashMap<>();
    private final Map<Long, Message> answers = new LinkedHashMap<>();
    /** Newest request by frame. */
    private final Map<Integer, Long> newestCalls = new HashMap<>();
    /** Request of the cached film, by frame. */
    private final Map<Integer, Long> shownCalls = new HashMap<>();
    /** Locks by frame: one request at a time works on a frame. */
    private final Map<Integer, Object> locks = new HashMap<>();
    private long filmCall = -1;
    private @Nullable Film film;

    private record ContentKey(ContentHash hash, long offset) {}

    NodeSession(ClusterMember owner, UUID id, FrameHost host, ContentFolder contents, Consumer<Message> send) {
        this.owner = owner;
        this.id = id;
        this.host = host;
        this.send = send;
        reader = new RevisionReader(contents, (hash, offset) -> contentRequests.request(new ContentKey(hash, offset),
                () -> send.accept(new Message.RequestContent(id, hash, offset)), () -> false));
    }

    void contentReceived(Message.ContentPart part) {
        contentRequests.complete(new ContentKey(part.hash(), part.offset()), part.bytes());
    }

    synchronized void updateFrame(Message.UpdateFrame request) {
        Message answer = answers.get(request.call());
        if (answer != null) {
            send.accept(answer);
        } else if (!runningCalls.containsKey(request.call()) && runningCalls.size() < MAX_CALLS) {
            var canceled = new AtomicBoolean();
            runningCalls.put(request.call(), canceled);
            newestCalls.merge(request.frame(), request.call(), Math::max);
            execute(callExecutor, () -> answer(request.call(), process(request, canceled)));
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
            runningCalls.remove(call);
            answers.put(call, answer);
            if (answers.size() > MAX_ANSWERS) {
                answers.remove(answers.keySet().iterator().next());
            }
        }
        send.accept(answer);
    }

    private Message process(Message.UpdateFrame request, AtomicBoolean canceled) {
        try {
            return updateFrameNow(request, canceled);
        } catch (CancellationException e) {
            return failure(request, Message.FailureReason.CANCELED, "");
        } catch (PictureTooLargeException e) {
            drop(request.frame());
            return failure(request, Message.FailureReason.REJECTED, String.valueOf(e.getMessage()));
        } catch (OutOfMemoryError e) {
            drop(request.frame());
            return failure(request, Message.FailureReason.REJECTED, "not enough memory");
        } catch (InvalidContentException | WireException | JenException | IllegalArgumentException | HostLostException e) {
            return failure(request, Message.FailureReason.INVALID, String.valueOf(e.getMessage()));
        } catch (FrameRejectedException | IOException e) {
            return failure(request, Message.FailureReason.REJECTED, String.valueOf(e.getMessage()));
        } catch (RuntimeException | Error e) {
            return failure(request, Message.FailureReason.ERROR, e.toString());
        }
    }

    private Message failure(Message.UpdateFrame request, Message.FailureReason reason, String message) {
        return new Message.UpdateFailed(id, request.call(), reason, message);
    }

    private Message updateFrameNow(Message.UpdateFrame request, AtomicBoolean canceled)
            throws IOException, WireException, JenException, HostLostException {
        var revision = reader.read(request.manifest(), request.manifestBytes());
        synchronized (lock(request.frame())) {
            if (isSuperseded(request)) {
                throw new CancellationException();
            }
            FrameUpdate update = trace(request.frame(), revision, canceled);
            synchronized (this) {
                shownCalls.put(request.frame(), request.call());
            }
            Film film = update.film();
            CacheUsage usage = host.usage();
            return new Message.FrameUpdated(id, request.call(), update.traced(), update.plan(), update.rays(), update.nanoseconds(),
                    film.width(),
                    film.height(), usage.memoryBytes(), usage.diskBytes());
        }
    }

    private FrameUpdate trace(int frame, ShotRevision revision, AtomicBoolean canceled) throws HostLostException {
        try {
            return tracingExecutor.submit(() -> host.update(frame, revision, Progress.cancellation(canceled::get))).get();
        } catch (InterruptedException e) {
            canceled.set(true);
            throw new CancellationException();
        } catch (ExecutionException e) {
            switch (requireNonNull(e.getCause())) {
                case HostLostException cause -> throw cause;
                case RuntimeException cause -> throw cause;
                case Error cause -> throw cause;
                case Throwable cause -> throw new IllegalStateException(cause);
            }
        }
    }

    private synchronized Object lock(int frame) {
        return locks.computeIfAbsent(frame, _ -> new Object());
    }

    private synchronized boolean isSuperseded(Message.UpdateFrame request) {
        return requireNonNull(newestCalls.get(request.frame())) != request.call();
    }

    synchronized void cancel(long call) {
        AtomicBoolean canceled = runningCalls.get(call);
        if (canceled != null) {
            canceled.set(true);
        }
    }

    void sendTiles(Message.RequestTiles request) {
        execute(filmExecutor, () -> {
            byte[] bytes = film(request)
                    .map(f -> FilmTiles.encode(downscale(f, request), request.firstTile(), request.tileCount())).orElse(new byte[0]);
            send.accept(bytes.length == 0 ? new Message.FilmUnavailable(id, request.call(), request.frame())
                    : new Message.FilmTileData(id, request.call(), request.frame(), request.maxWidth(), request.maxHeight(),
                            request.firstTile(), bytes));
        });
    }

    private static Film downscale(Film film, Message.RequestTiles request) {
        return Downscale.fit(film.width(), film.height(), Math.max(1, request.maxWidth()), Math.max(1, request.maxHeight())).apply(film);
    }

    /**
     * Returns the film of a request. Runs on the single film thread and caches the last film, because its tiles are requested one after the
     * other.
     */
    private Optional<Film> film(Message.RequestTiles request) {
        if (filmCall == request.call()) {
            return Optional.ofNullable(film);
        }
        synchronized (lock(request.frame())) {
            synchronized (this) {
                if (!shownCalls.getOrDefault(request.frame(), -1L).equals(request.call())) {
                    return Optional.empty();
                }
            }
            Optional<Film> cached = host.film(request.frame());
            cached.ifPresent(f -> {
                film = f;
                filmCall = request.call();
            });
            return cached;
        }
    }

    void setFocus(int frame) {
        host.focus(frame);
    }

    void drop(int frame) {
        synchronized (this) {
            shownCalls.remove(frame);
        }
        host.drop(frame);
    }

    /** Cancels running work and drops all frames, without blocking the caller. A second call has no effect. */
    @Override
    public void close() {
        contentRequests.close();
        synchronized (this) {
            runningCalls.values().forEach(cancelled -> cancelled.set(true));
        }
        filmExecutor.shutdownNow();
        execute(callExecutor, this::awaitCalls);
        callExecutor.shutdown();
    }

    private void awaitCalls() {
        try {
            while (isWorking()) {
                Thread.sleep(10);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            tracingExecutor.shutdown();
            host.close();
        }
    }

    private synchronized boolean isWorking() {
        return !runningCalls.isEmpty();
    }
}
