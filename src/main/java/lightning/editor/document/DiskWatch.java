package lightning.editor.document;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import lightning.base.file.FileState;
import lightning.base.work.OwnThread;

/**
 * Looks now and then, on a thread of its own, whether others wrote the open scene's file or have it open too; a file
 * system that does not answer holds up nobody else. Safe for several threads.
 */
public final class DiskWatch implements AutoCloseable {
    public static final Duration DEFAULT_PERIOD = Duration.ofSeconds(1);

    private final Presence presence;
    private final Consumer<DiskNews> heard;
    private final ScheduledThreadPoolExecutor thread;
    /** What is watched, and no news of it yet; null before the first. */
    private volatile DiskNews watched;
    /** Only the watching thread knows these. */
    private DiskNews last;
    private Path announced;

    /**
     * @param presence tells other editors of the file, and of them; closed with the watch
     * @param heard    hears, on the watching thread, what is seen first of a file, and then every change
     */
    public DiskWatch(Presence presence, Duration period, Consumer<DiskNews> heard) {
        this.presence = presence;
        this.heard = heard;
        thread = new ScheduledThreadPoolExecutor(1, OwnThread.named("lightning-disk"), new ThreadPoolExecutor.DiscardPolicy());
        thread.setContinueExistingPeriodicTasksAfterShutdownPolicy(false);
        thread.scheduleWithFixedDelay(this::tick, period.toMillis(), period.toMillis(), TimeUnit.MILLISECONDS);
    }

    /** Watches a file from now on, in place of the one before. Nothing happens where it is watched already. */
    public void watch(Path file, FileState known) {
        DiskNews now = watched;
        if (now == null || !now.file().equals(file) || !now.known().equals(known)) {
            watched = new DiskNews(file, known, known, false);
            look();
        }
    }

    /** Looks at once, as when the artist comes back from another program. */
    public void look() {
        thread.execute(this::tick);
    }

    private void tick() {
        DiskNews now = watched;
        if (now == null) {
            return;
        }
        try {
            DiskNews news = new DiskNews(now.file(), now.known(), seen(now), elsewhere(now.file()));
            if (!news.equals(last)) {
                last = news;
                heard.accept(news);
            }
        } catch (IOException | RuntimeException e) {
            // What cannot be seen now may be seen the next time; a save finds out by itself.
        }
    }

    /** Reads the file only where time or size say that it is another than was seen last. */
    private FileState seen(DiskNews now) throws IOException {
        FileState look = FileState.look(now.file());
        if (look.looksLike(now.known())) {
            return now.known();
        }
        boolean again = last != null && last.file().equals(now.file()) && last.seen().looksLike(look);
        return again ? last.seen() : FileState.of(now.file());
    }

    private boolean elsewhere(Path file) {
        try {
            if (!file.equals(announced)) {
                presence.open(file);
                announced = file;
            }
            return presence.isOpenElsewhere(file);
        } catch (IOException e) {
            // Editors that cannot hear of each other still ask before they overwrite.
            return false;
        }
    }

    /** Does not wait for a look that is under way. */
    @Override
    public void close() {
        thread.execute(presence::close);
        thread.shutdown();
    }
}
