package lightning.base.work;

import java.time.Duration;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/** Limit of time for code of others that may never end. */
public final class TimeLimit {
    private TimeLimit() {}

    /**
     * Runs a task on a thread of its own. A task that does not end in time keeps its thread, and a processor, until the program ends,
     * since Java cannot end it.
     *
     * @throws ExecutionException with what the task has thrown
     * @throws TimeoutException if it does not end in time
     * @throws CancellationException if this thread is interrupted before the task has ended
     */
    public static <T> T call(String name, Duration limit, Callable<T> task) throws ExecutionException, TimeoutException {
        var result = new FutureTask<>(task);
        DedicatedThread.create(name, result).start();
        try {
            return result.get(limit.toNanos(), TimeUnit.NANOSECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new CancellationException("interrupted: " + name);
        }
    }
}
