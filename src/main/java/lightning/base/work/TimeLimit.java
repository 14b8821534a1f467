package lightning.base.work;

import java.time.Duration;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Limit of time for several tasks together, of code of others that may never end. Used by one thread at a time.
 *
 * <p>A task that does not end in time is interrupted. {@link InterruptibleClasses} make one of any code end then.
 */
public final class TimeLimit {
    private long remaining;

    /** @param limit of all tasks */
    public TimeLimit(Duration limit) {
        remaining = limit.toNanos();
    }

    /**
     * Runs a task on a thread of its own.
     *
     * @param own time that this task adds to the limit
     * @throws ExecutionException with what the task has thrown
     * @throws TimeoutException if it does not end in time, or if an earlier one did not
     * @throws CancellationException if this thread is interrupted before the task has ended
     */
    public <T> T call(String name, Duration own, Callable<T> task) throws ExecutionException, TimeoutException {
        if (remaining <= 0) {
            throw new TimeoutException(name);
        }
        remaining += own.toNanos();
        var result = new FutureTask<>(task);
        Thread thread = DedicatedThread.create(name, result);
        long start = System.nanoTime();
        thread.start();
        try {
            return result.get(remaining, TimeUnit.NANOSECONDS);
        } catch (TimeoutException e) {
            thread.interrupt();
            throw e;
        } catch (InterruptedException e) {
            thread.interrupt();
            Thread.currentThread().interrupt();
            throw new CancellationException("interrupted: " + name);
        } finally {
            remaining -= System.nanoTime() - start;
        }
    }
}
