package lightning.editor.document;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import lightning.base.file.FileState;
import lightning.base.work.DedicatedThread;

/**
 * Looks now and then, on a thread of its own, whether others wrote the open scene's file or have it open too; a file
 * system that does not answer holds up nobody else. Safe for several threads.
 */
public final class DiskWatch implements AutoCloseable {
    public static final Duration DEFAULT_PERIOD = Duration.ofSeconds(1);

    private final OpenSceneRegistry openScenes;
    private final Consumer<DiskStatus> listener;
    private final ScheduledThreadPoolExecutor thread;
    /** What is watched, and no news of it yet; null before the first. */
    private volatile DiskStatus watched;
    /** Only the watching thread knows these. */
    private DiskStatus lastReported;
    private Path registeredFile;

    /**
     * @param openScenes tells other editors of the file, and of them; closed with the watch
     * @param listener    hears, on the watching thread, what is seen first of a file, and then every change
     */
    public DiskWatch(OpenSceneRegistry openScenes, Duration period, Consumer<DiskStatus> listener) {
        this.openScenes = openScenes;
        this.listener = listener;
        thread = new ScheduledThreadPoolExecutor(1, DedicatedThread.factory("lightning-disk"), new ThreadPoolExecutor.DiscardPolicy());
        thread.setContinueExistingPeriodicTasksAfterShutdownPolicy(false);
        thread.scheduleWithFixedDelay(this::check, period.toMillis(), period.toMillis(), TimeUnit.MILLISECONDS);
    }

    /** Watches a file from now on, in place of the one before. Nothing happens where it is watched already. */
    public void watch(Path file, FileState known) {
        DiskStatus current = watched;
        if (current == null || !current.file().equals(file) || !current.known().equals(known)) {
            watched = new DiskStatus(file, known, known, false);
            checkNow();
        }
    }

    /** Looks at once, as when the artist comes back from another program. */
    public void checkNow() {
        thread.execute(this::check);
    }

    private void check() {
        DiskStatus target = watched;
        if (target == null) {
            return;
        }
        try {
            DiskStatus status = new DiskStatus(target.file(), target.known(), currentState(target), isOpenElsewhere(target.file()));
            if (!status.equals(lastReported)) {
                lastReported = status;
                listener.accept(status);
            }
        } catch (IOException | RuntimeException e) {
            // What cannot be seen now may be seen the next time; a save finds out by itself.
        }
    }

    /** Reads the file only where time or size say that it is another than was seen last. */
    private FileState currentState(DiskStatus target) throws IOException {
        FileState quickState = FileState.readMetadata(target.file());
        if (quickState.hasSameMetadata(target.known())) {
            return target.known();
        }
        boolean isUnchanged =
                lastReported != null && lastReported.file().equals(target.file()) && lastReported.current().hasSameMetadata(quickState);
        return isUnchanged ? lastReported.current() : FileState.of(target.file());
    }

    private boolean isOpenElsewhere(Path file) {
        try {
            if (!file.equals(registeredFile)) {
                openScenes.register(file);
                registeredFile = file;
            }
            return openScenes.isOpenElsewhere(file);
        } catch (IOException e) {
            // Editors that cannot hear of each other still ask before they overwrite.
            return false;
        }
    }

    /** Does not wait for a look that is under way. */
    @Override
    public void close() {
        thread.execute(openScenes::close);
        thread.shutdown();
    }
}
