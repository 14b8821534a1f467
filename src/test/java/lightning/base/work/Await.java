package lightning.base.work;

import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/** Waits for what other threads do. */
public final class Await {
    /** Seconds: far more than anything takes on a machine that has other work: only what never comes about takes so long. */
    public static final int TIMEOUT_SECONDS = 120;

    private Await() {}

    /** Returns as soon as the condition holds. */
    public static void until(Callable<Boolean> condition) throws Exception {
        until("it came about", condition);
    }

    /** Returns as soon as the condition holds that a sentence with "until" would end with. */
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
     * Returns as soon as no thread of that name runs: what was closed without waiting writes no file from then on, and the test's folder
     * can go.
     */
    public static void untilThreadEnded(String name) throws Exception {
        until("no thread " + name + " runs",
                () -> Thread.getAllStackTraces().keySet().stream().noneMatch(thread -> thread.getName().equals(name)));
    }
}
