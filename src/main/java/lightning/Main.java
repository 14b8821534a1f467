package lightning;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import lightning.cli.Lightning;

/** Starts the program. */
public final class Main {
    /** How long Ctrl-C waits for a command to put away what it was writing. */
    private static final int PATIENCE_SECONDS = 5;

    private Main() {}

    /** Runs the command named by the arguments and exits with its code. */
    public static void main(String[] args) {
        Thread command = Thread.currentThread();
        CountDownLatch finished = new CountDownLatch(1);
        Runtime.getRuntime().addShutdownHook(new Thread(() -> cancel(command, finished), "lightning-interrupt"));
        int exit = Lightning.run(System.out, System.err, args);
        finished.countDown();
        System.exit(exit);
    }

    /** An interrupted command removes its temporary file before the process ends. */
    private static void cancel(Thread command, CountDownLatch finished) {
        if (finished.getCount() == 0) {
            return;
        }
        command.interrupt();
        try {
            finished.await(PATIENCE_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
