package lightning.base.work;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.ThreadFactory;

/** Factory for background threads; all are daemon threads. */
public final class DedicatedThread {
    private DedicatedThread() {}

    /** Creates a thread for one task; the caller starts it. */
    public static Thread create(String name, Runnable task) {
        Thread thread = new Thread(task, name);
        thread.setDaemon(true);
        return thread;
    }

    /** Returns a factory of threads with one name. */
    public static ThreadFactory factory(String name) {
        return task -> create(name, task);
    }

    /** Returns an executor with a virtual thread for each task, for tasks that mostly wait. */
    public static ExecutorService virtualThreadExecutor(String name) {
        return Executors.newThreadPerTaskExecutor(Thread.ofVirtual().name(name).factory());
    }

    /** Returns an executor with one thread that runs its tasks in order; the thread starts with the first task. */
    public static ExecutorService sequentialExecutor(String name) {
        return Executors.newSingleThreadExecutor(factory(name));
    }

    /** Like {@link #sequentialExecutor}, with threads of {@link #lowPriorityFactory}. */
    public static ExecutorService lowPriorityExecutor(String name) {
        return Executors.newSingleThreadExecutor(lowPriorityFactory(name));
    }

    /**
     * Returns a factory of threads with one name and low operating-system priority, also for the threads that their tasks start: {@link
     * LowPriority}.
     */
    public static ThreadFactory lowPriorityFactory(String name) {
        return task -> create(name, () -> {
            LowPriority.apply();
            task.run();
        });
    }
}
