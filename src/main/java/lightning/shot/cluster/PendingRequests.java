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
 * Pending requests to another member, repeated until they are answered, because messages may be lost.
 *
 * @param <K> key of a request; equal keys share an answer
 * @param <V> answer
 */
final class PendingRequests<K, V> {
    /** Interval between retries. */
    static final long RETRY_MILLISECONDS = 2000;
    /** Interval at which a waiting caller checks for cancellation. */
    private static final long POLL_MILLISECONDS = 20;

    private final Map<K, CompletableFuture<V>> pending = new ConcurrentHashMap<>();
    private volatile boolean closed;

    /**
     * Sends a request and waits for its answer.
     *
     * @param send     sends the request
     * @param canceled returns true if the answer is not needed any more
     * @throws CancellationException if canceled or closed
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
                        // No answer yet.
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

    /** Completes a request; ignored if it is not pending. */
    void complete(K key, V answer) {
        CompletableFuture<V> future = pending.get(key);
        if (future != null) {
            future.complete(answer);
        }
    }

    /** Completes several requests with one answer. */
    void completeAll(Predicate<K> filter, V answer) {
        pending.forEach((key, waits) -> {
            if (filter.test(key)) {
                waits.complete(answer);
            }
        });
    }

    /** Cancels all pending requests. */
    void close() {
        closed = true;
    }

    boolean isClosed() {
        return closed;
    }
}
