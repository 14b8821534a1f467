package lightning.base.work;

import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/** Waits for conditions that other threads establish. */
public final class Await {
    /** Seconds: far longer than any passing condition takes on a busy machine. */
    public static final int TIMEOUT_SECONDS = 120;

    private Await() {}

    /** Returns as soon as the condition holds. */
    public static void until(Callable<Boolean> condition) throws Exception {
        until("the condition holds", condition);
    }

    /** Returns as soon as the described condition holds. */
    public static void until(String description, Callable<Boolean> condition) throws Exception {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(TIMEOUT_SECONDS);
        while (!condition.call()) {
            if (System.nanoTime() > end) {
                throw new AssertionError("waited " + TIMEOUT_SECONDS + " s until " + description);
            }
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(1));
        }
    }

    /**
     * Waits until the processes ended. Such a process has no command line, even if its parent ended before and its exit code is never
     * read.
     */
    public static void untilEnded(List<ProcessHandle> processes) throws Exception {
        until("the processes ended", () -> processes.stream().noneMatch(p -> p.info().commandLine().isPresent()));
    }

    /** Waits until no thread of that name runs. Then the test's folder can be removed, because the thread writes no files. */
    public static void untilThreadEnded(String name) throws Exception {
        until("no thread " + name + " runs",
                () -> Thread.getAllStackTraces().keySet().stream().noneMatch(thread -> thread.getName().equals(name)));
    }
}
