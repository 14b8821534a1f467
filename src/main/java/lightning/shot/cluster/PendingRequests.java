package lightning.shot.cluster;

import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;

/**
 * Asks another member until it answers: what is lost on the way is asked for again.
 *
 * @param <K> what is asked for; equal keys share an answer
 * @param <V> the answer
 */
final class PendingRequests<K, V> {
    /** After so long without an answer it is asked again. */
    static final long RETRY_MILLISECONDS = 2000;
    /** So often the one who waits looks whether it still wants to. */
    private static final long POLL_MILLISECONDS = 20;

    private final Map<K, CompletableFuture<V>> pending = new ConcurrentHashMap<>();
    private volatile boolean closed;

    /**
     * Waits for an answer.
     *
     * @param send  sends the question
     * @param canceled whether nobody wants the answer any more
     * @throws CancellationException if so, or this is closed
     */
    V request(K key, Runnable send, BooleanSupplier canceled) {
        CompletableFuture<V> answer = pending.computeIfAbsent(key, _ -> new CompletableFuture<>());
        try {
            while (true) {
                send.run();
                long sentAt = System.nanoTime();
                while (System.nanoTime() - sentAt < TimeUnit.MILLISECONDS.toNanos(RETRY_MILLISECONDS)) {
                    if (closed || canceled.getAsBoolean()) {
                        throw new CancellationException();
                    }
                    try {
                        return answer.get(POLL_MILLISECONDS, TimeUnit.MILLISECONDS);
                    } catch (TimeoutException e) {
                        // Not yet.
                    }
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new CancellationException();
        } catch (ExecutionException e) {
            throw new IllegalStateException(e);
        } finally {
            pending.remove(key, answer);
        }
    }

    /** An answer came; where nobody waits for it, nothing happens. */
    void complete(K key, V answer) {
        CompletableFuture<V> future = pending.get(key);
        if (future != null) {
            future.complete(answer);
        }
    }

    /** One answer to several questions. */
    void completeAll(Predicate<K> filter, V answer) {
        pending.forEach((key, waits) -> {
            if (filter.test(key)) {
                waits.complete(answer);
            }
        });
    }

    /** Whoever waits stops. */
    void close() {
        closed = true;
    }

    boolean isClosed() {
        return closed;
    }
}
