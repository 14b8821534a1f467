package lightning.base.work;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.ThreadFactory;

/** Threads that do one kind of work beside all others; none keeps the process alive. */
public final class OwnThread {
    private OwnThread() {}

    /** A thread, not started, that does one task. */
    public static Thread of(String name, Runnable task) {
        Thread thread = new Thread(task, name);
        thread.setDaemon(true);
        return thread;
    }

    /** Makes threads of one name. */
    public static ThreadFactory named(String name) {
        return task -> of(name, task);
    }

    /** A light thread for each task, for those that wait for others most of the time. */
    public static ExecutorService forEach(String name) {
        return Executors.newThreadPerTaskExecutor(Thread.ofVirtual().name(name).factory());
    }

    /** A thread that does what it is given in turn; it begins with the first task. */
    public static ExecutorService inTurn(String name) {
        return Executors.newSingleThreadExecutor(named(name));
    }

    /** The same for what nobody waits for, of low rank for the operating system, as all threads are that it starts: {@link LowRank}. */
    public static ExecutorService inTurnBehind(String name) {
        return Executors.newSingleThreadExecutor(task -> of(name, () -> {
            LowRank.take();
            task.run();
        }));
    }
}
