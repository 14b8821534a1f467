package lightning.modelcheck;

import java.util.concurrent.atomic.AtomicReference;
import org.jetbrains.lincheck.Lincheck;

/**
 * Runs a multithreaded scenario in many schedules: the model checker chooses at each access to shared memory which thread continues. The
 * schedules are deterministic; reports a violated assertion, or a scenario that never ends, with its schedule.
 *
 * <p>Memory is sequentially consistent here, so errors due to weak memory ordering are not found.
 */
public final class ScheduleExplorer {
    /** Maximum number of schedules: -Dlightning.schedules=N. */
    private static final int MAX_SCHEDULES = Integer.getInteger("lightning.schedules", 50);

    /** Actions of the threads, with assertions. */
    @FunctionalInterface
    public interface Scenario {
        void tell() throws InterruptedException;
    }

    private ScheduleExplorer() {}

    /** Runs the scenario in all schedules; fails at the first violated assertion. Its threads must end with it. */
    public static void explore(Scenario scenario) {
        Lincheck.runConcurrentTest(MAX_SCHEDULES, () -> runScenario(scenario));
    }

    /** Checks an assertion. The model checker would step through AssertJ's code. */
    public static void check(boolean holds, String law) {
        if (!holds) {
            throw new AssertionError(law);
        }
    }

    /** Starts a further thread; {@link ConcurrentRun#end} rethrows its exception. */
    public static ConcurrentRun startConcurrently(Scenario scenario) {
        return new ConcurrentRun(scenario);
    }

    private static void runScenario(Scenario scenario) {
        try {
            scenario.tell();
        } catch (InterruptedException e) {
            throw new AssertionError("no interrupt expected", e);
        }
    }

    /** Thread of a scenario. */
    public static final class ConcurrentRun {
        private final AtomicReference<Throwable> problem = new AtomicReference<>();
        private final Thread thread;

        private ConcurrentRun(Scenario scenario) {
            thread = new Thread(() -> {
                try {
                    ScheduleExplorer.runScenario(scenario);
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
