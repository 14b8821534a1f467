package lightning.base.work;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.ThreadFactory;

/** Threads that do one kind of work beside all others; none keeps the process alive. */
public final class DedicatedThread {
    private DedicatedThread() {}

    /** A thread, not started, that does one task. */
    public static Thread create(String name, Runnable task) {
        Thread thread = new Thread(task, name);
        thread.setDaemon(true);
        return thread;
    }

    /** Makes threads of one name. */
    public static ThreadFactory factory(String name) {
        return task -> create(name, task);
    }

    /** A light thread for each task, for those that wait for others most of the time. */
    public static ExecutorService virtualThreadExecutor(String name) {
        return Executors.newThreadPerTaskExecutor(Thread.ofVirtual().name(name).factory());
    }

    /** A thread that does what it is given in turn; it begins with the first task. */
    public static ExecutorService sequentialExecutor(String name) {
        return Executors.newSingleThreadExecutor(factory(name));
    }

    /** The same for what nobody waits for, of low rank for the operating system, as all threads are that it starts: {@link LowPriority}. */
    public static ExecutorService lowPriorityExecutor(String name) {
        return Executors.newSingleThreadExecutor(task -> create(name, () -> {
            LowPriority.apply();
            task.run();
        }));
    }
}
