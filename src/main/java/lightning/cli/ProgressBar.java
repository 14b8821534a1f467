package lightning.cli;

import java.util.function.LongSupplier;
import lightning.base.work.Progress;

/**
 * A line on the terminal that tells how far a work is and how long it will still take, once it has taken a second;
 * nothing where no terminal is. The work stops when the thread that made the bar is interrupted.
 *
 * <p>Own code, because the known libraries for this bring a terminal library of a megabyte with them for what is one
 * line of text here.
 */
final class ProgressBar implements Progress, AutoCloseable {
    private static final int WIDTH = 30;
    private static final long SECOND = 1_000_000_000;
    private static final long UPDATE_INTERVAL = SECOND / 10;
    /** Goes to the line's start and erases it. */
    private static final String ERASE = "\r\u001b[K";

    private final Console console;
    private final String title;
    private final LongSupplier clock;
    private final Thread owner = Thread.currentThread();
    private final long start;
    private long lastUpdate;
    private boolean visible;

    ProgressBar(Console console, String title) {
        this(console, title, System::nanoTime);
    }

    /** @param clock nanoseconds from any origin */
    ProgressBar(Console console, String title, LongSupplier clock) {
        this.console = console;
        this.title = title;
        this.clock = clock;
        start = clock.getAsLong();
        lastUpdate = start + SECOND - UPDATE_INTERVAL;
    }

    @Override
    public synchronized void report(int done, int total) {
        long now = clock.getAsLong();
        if (!console.terminal() || now - lastUpdate < UPDATE_INTERVAL) {
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

    static String duration(double seconds) {
        long rounded = (long) Math.ceil(seconds);
        return rounded < 60 ? rounded + " s" : Console.text("%d:%02d min", rounded / 60, rounded % 60);
    }

    @Override
    public boolean isCanceled() {
        return owner.isInterrupted();
    }

    /** Makes room for other output; the next step shows the bar again. */
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
    }
}
