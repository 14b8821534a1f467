package lightning.modelcheck;

import java.util.concurrent.atomic.AtomicReference;
import org.jetbrains.lincheck.Lincheck;

/**
 * Runs a story of several threads in one schedule after the other: the model checker decides at each access to shared memory
 * which thread goes on. The same schedules each time; a law that is broken is told with the schedule that broke it, and so is
 * a story that never ends.
 *
 * <p>Memory is sequentially consistent here: what only a processor's caches could break is not found.
 */
public final class ScheduleExplorer {
    /** So many schedules, unless the story has fewer: -Dlightning.schedules=N. */
    private static final int MAX_SCHEDULES = Integer.getInteger("lightning.schedules", 50);

    /** What the threads do, and the laws that hold. */
    @FunctionalInterface
    public interface Scenario {
        void tell() throws InterruptedException;
    }

    private ScheduleExplorer() {}

    /** Tells the story in all schedules; fails at the first that breaks a law. Threads must end with the story. */
    public static void explore(Scenario story) {
        Lincheck.runConcurrentTest(MAX_SCHEDULES, () -> runScenario(story));
    }

    /** A law. AssertJ's would be looked into by the model checker, step for step. */
    public static void check(boolean holds, String law) {
        if (!holds) {
            throw new AssertionError(law);
        }
    }

    /** Starts a thread beside the story's own; {@link ConcurrentRun#end} hands on what it threw. */
    public static ConcurrentRun startConcurrently(Scenario story) {
        return new ConcurrentRun(story);
    }

    private static void runScenario(Scenario story) {
        try {
            story.tell();
        } catch (InterruptedException e) {
            throw new AssertionError("nobody interrupts", e);
        }
    }

    /** A thread of a story. */
    public static final class ConcurrentRun {
        private final AtomicReference<Throwable> problem = new AtomicReference<>();
        private final Thread thread;

        private ConcurrentRun(Scenario story) {
            thread = new Thread(() -> {
                try {
                    ScheduleExplorer.runScenario(story);
                } catch (Throwable e) {
                    problem.set(e);
                }
            });
            thread.start();
        }

        /** Waits for its end. */
        public void end() throws InterruptedException {
            thread.join();
            if (problem.get() != null) {
                throw new AssertionError(problem.get().getMessage(), problem.get());
            }
        }
    }
}
