package lightning.cli.output;

import java.util.function.LongSupplier;
import lightning.base.work.Progress;

/**
 * Progress line on the terminal with the estimated remaining time, shown after one second; prints nothing without a
 * terminal. Work is canceled when the thread that created the bar is interrupted.
 *
 * <p>Own code, because the known libraries add a terminal library of a megabyte for one line of text.
 */
public final class ProgressBar implements Progress, AutoCloseable {
    private static final int WIDTH = 30;
    private static final long SECOND = 1_000_000_000;
    private static final long UPDATE_INTERVAL = SECOND / 10;
    /** Moves to the start of the line and erases it. */
    private static final String ERASE = "\r\u001b[K";

    private final Console console;
    private final String title;
    private final LongSupplier clock;
    private final Thread owner = Thread.currentThread();
    private final long start;
    private long lastUpdate;
    private boolean visible;

    public ProgressBar(Console console, String title) {
        this(console, title, System::nanoTime);
    }

    /**
     * Creates a bar with a given clock.
     *
     * @param clock nanoseconds from any origin
     */
    public ProgressBar(Console console, String title, LongSupplier clock) {
        this.console = console;
        this.title = title;
        this.clock = clock;
        start = clock.getAsLong();
        console.report().setBar(this);
        lastUpdate = start + SECOND - UPDATE_INTERVAL;
    }

    @Override
    public synchronized void report(int done, int total) {
        long now = clock.getAsLong();
        if (!console.showsProgress() || now - lastUpdate < UPDATE_INTERVAL) {
            return;
        }
        lastUpdate = now;
        visible = true;
        console.out().print(ERASE + text(done, total, (now - start) / 1e9));
        console.out().flush();
    }

    private String text(int done, int total, double seconds) {
        int filled = (int) ((long) WIDTH * done / total);
        double remaining = seconds * (total - done) / Math.max(done, 1);
        return Console.text("%s [%s%s] %3d %%, %s left", title, "#".repeat(filled), "-".repeat(WIDTH - filled),
                (int) (100L * done / total), duration(remaining));
    }

    /** Returns a time in words, rounded up to seconds. */
    public static String duration(double seconds) {
        long rounded = (long) Math.ceil(seconds);
        return rounded < 60 ? rounded + " s" : Console.text("%d:%02d min", rounded / 60, rounded % 60);
    }

    @Override
    public boolean isCanceled() {
        return owner.isInterrupted();
    }

    /** Erases the bar to make room for a line; the next step shows it again. */
    synchronized void erase() {
        if (visible) {
            console.out().print(ERASE);
            console.out().flush();
            visible = false;
        }
    }

    @Override
    public void close() {
        erase();
        console.report().setBar(null);
    }
}
