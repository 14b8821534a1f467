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
final class Asker<K, V> {
    /** After so long without an answer it is asked again. */
    static final long AGAIN_MILLISECONDS = 2000;
    /** So often the one who waits looks whether it still wants to. */
    private static final long LOOK_MILLISECONDS = 20;

    private final Map<K, CompletableFuture<V>> waiting = new ConcurrentHashMap<>();
    private volatile boolean closed;

    /**
     * Waits for an answer.
     *
     * @param ask  sends the question
     * @param stop whether nobody wants the answer any more
     * @throws CancellationException if so, or this is closed
     */
    V ask(K key, Runnable ask, BooleanSupplier stop) {
        CompletableFuture<V> answer = waiting.computeIfAbsent(key, _ -> new CompletableFuture<>());
        try {
            while (true) {
                ask.run();
                long asked = System.nanoTime();
                while (System.nanoTime() - asked < TimeUnit.MILLISECONDS.toNanos(AGAIN_MILLISECONDS)) {
                    if (closed || stop.getAsBoolean()) {
                        throw new CancellationException();
                    }
                    try {
                        return answer.get(LOOK_MILLISECONDS, TimeUnit.MILLISECONDS);
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
            waiting.remove(key, answer);
        }
    }

    /** An answer came; where nobody waits for it, nothing happens. */
    void answered(K key, V answer) {
        CompletableFuture<V> waits = waiting.get(key);
        if (waits != null) {
            waits.complete(answer);
        }
    }

    /** One answer to several questions. */
    void answeredAll(Predicate<K> which, V answer) {
        waiting.forEach((key, waits) -> {
            if (which.test(key)) {
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
