package lightning.document;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import lightning.base.file.FileState;
import lightning.base.work.DedicatedThread;
import org.jspecify.annotations.Nullable;

/**
 * Periodic check, on its own thread, for changes to the open scene's file by other programs, and for other editors that have it open. A
 * file system that does not respond blocks no other thread. Thread-safe.
 */
public final class DiskWatch implements AutoCloseable {
    public static final Duration DEFAULT_PERIOD = Duration.ofSeconds(1);

    private final OpenSceneRegistry openScenes;
    private final Consumer<DiskStatus> listener;
    private final ScheduledThreadPoolExecutor thread;
    /** Watched file, without its current state; null before the first. */
    private volatile @Nullable DiskStatus watched;
    /** Accessed on the watch thread only. */
    private @Nullable DiskStatus lastReported;
    private @Nullable Path registeredFile;

    /**
     * @param openScenes registry of the scenes in all editors; closed with the watch
     * @param listener   receives, on the watch thread, the first state of a file and every change
     */
    public DiskWatch(OpenSceneRegistry openScenes, Duration period, Consumer<DiskStatus> listener) {
        this.openScenes = openScenes;
        this.listener = listener;
        thread = new ScheduledThreadPoolExecutor(1, DedicatedThread.factory("lightning-disk"), new ThreadPoolExecutor.DiscardPolicy());
        thread.setContinueExistingPeriodicTasksAfterShutdownPolicy(false);
        thread.scheduleWithFixedDelay(this::check, period.toMillis(), period.toMillis(), TimeUnit.MILLISECONDS);
    }

    /** Switches to another file. Does nothing if it is already watched. */
    public void watch(Path file, FileState known) {
        DiskStatus current = watched;
        if (current == null || !current.file().equals(file) || !current.known().equals(known)) {
            watched = new DiskStatus(file, known, known, false);
            checkNow();
        }
    }

    /** Stops until another file is watched. */
    public void pause() {
        watched = null;
    }

    /** Checks immediately, for example when the window regains focus. */
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
            // Retried at the next check; a save checks the file itself.
        }
    }

    /** Reads the file only if its time or size has changed. */
    private FileState currentState(DiskStatus target) throws IOException {
        FileState quickState = FileState.readMetadata(target.file());
        if (quickState.hasSameMetadata(target.known())) {
            return target.known();
        }
        boolean isUnchanged =
                lastReported != null && lastReported.file().equals(target.file()) && lastReported.current().hasSameMetadata(quickState);
        return lastReported != null && isUnchanged ? lastReported.current() : FileState.of(target.file());
    }

    private boolean isOpenElsewhere(Path file) {
        try {
            if (!file.equals(registeredFile)) {
                openScenes.register(file);
                registeredFile = file;
            }
            return openScenes.isOpenElsewhere(file);
        } catch (IOException e) {
            // Without the registry, editors still confirm before they overwrite.
            return false;
        }
    }

    /** Closes the watch without waiting for a running check. */
    @Override
    public void close() {
        thread.execute(openScenes::close);
        thread.shutdown();
    }
}
