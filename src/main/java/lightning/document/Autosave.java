package lightning.document;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import lightning.base.file.FileState;
import lightning.base.work.DedicatedThread;
import lightning.format.jen.JenDocument;
import lightning.scene.shot.AnimatedScene;
import org.jspecify.annotations.Nullable;

/** Autosave of unsaved edits on its own thread, shortly after the first edit, so that a crash loses only that short time. Thread-safe. */
public final class Autosave implements AutoCloseable {
    /** With the writing time, well below the allowed loss of five seconds. */
    public static final Duration DEFAULT_DELAY = Duration.ofSeconds(2);

    private static final int CLOSE_TIMEOUT_SECONDS = 5;

    private final RecoveryFolder recovery;
    private final Duration delay;
    private final Consumer<Throwable> failureListener;
    private final ScheduledThreadPoolExecutor thread;
    private final Set<Path> savedFiles = new HashSet<>();
    private @Nullable PendingSave pending;

    private record PendingSave(Path file, FileState known, JenDocument saved, AnimatedScene content) {}

    /** @param failureListener receives, on the autosave thread, any failure to save */
    public Autosave(RecoveryFolder recovery, Duration delay, Consumer<Throwable> failureListener) {
        this.recovery = recovery;
        this.delay = delay;
        this.failureListener = failureListener;
        thread = new ScheduledThreadPoolExecutor(1, DedicatedThread.factory("lightning-autosave"));
        thread.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
    }

    /** Schedules a save. Call it after each edit, undo or save. The autosave thread creates the text. */
    public synchronized void documentChanged(OpenDocument document) {
        if (!document.isDirty()) {
            discard();
            return;
        }
        if (pending == null) {
            thread.schedule(this::write, delay.toMillis(), TimeUnit.MILLISECONDS);
        }
        pending = new PendingSave(document.file(), document.knownState(), document.savedDocument(), document.content());
        savedFiles.add(document.file());
    }

    /** Discards the recovery data after the document was saved or closed on purpose, under all of its names. */
    public synchronized void discard() {
        pending = null;
        savedFiles.forEach(file -> thread.execute(() -> runOrReport(() -> recovery.delete(file))));
        savedFiles.clear();
    }

    /**
     * Adopts recovery data of a crashed process; see {@link RecoveryFolder#adopt}. Replaces a scheduled save, as it has the same content.
     *
     * @param onAdopted called on the autosave thread
     */
    public synchronized void adopt(RecoveryFolder.RecoverableScene recoverable, Runnable onAdopted) {
        pending = null;
        savedFiles.add(recoverable.file());
        thread.execute(() -> runOrReport(() -> {
            recovery.adopt(recoverable);
            onAdopted.run();
        }));
    }

    private void write() {
        PendingSave save;
        synchronized (this) {
            save = pending;
            pending = null;
        }
        if (save != null) {
            runOrReport(() -> recovery.store(save.file(), save.known(), save.saved().withAnimatedScene(save.content()).text()));
        }
    }

    private interface FileOperation {
        void run() throws IOException;
    }

    private void runOrReport(FileOperation operation) {
        try {
            operation.run();
        } catch (Exception | Error e) {
            // The executor of the thread would swallow any other failure.
            failureListener.accept(e);
        }
    }

    /** Finishes running saves; does not write pending edits. */
    @Override
    public void close() {
        synchronized (this) {
            pending = null;
        }
        thread.shutdown();
        try {
            thread.awaitTermination(CLOSE_TIMEOUT_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
