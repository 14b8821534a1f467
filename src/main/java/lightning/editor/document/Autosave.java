package lightning.editor.document;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import lightning.base.work.DedicatedThread;
import lightning.format.jen.JenDocument;
import lightning.scene.shot.AnimatedScene;

/**
 * Keeps unsaved edits on a thread of its own, a short while after the first of them, so that a crash loses no more than
 * that while. Safe for several threads.
 */
public final class Autosave implements AutoCloseable {
    /** With the time that writing takes, well below the five seconds that an artist may lose at most. */
    public static final Duration DEFAULT_DELAY = Duration.ofSeconds(2);

    private static final int CLOSE_TIMEOUT_SECONDS = 5;

    private final RecoveryFolder recovery;
    private final Duration delay;
    private final Consumer<Throwable> failureListener;
    private final ScheduledThreadPoolExecutor thread;
    private final Set<Path> savedFiles = new HashSet<>();
    private PendingSave pending;

    private record PendingSave(Path file, JenDocument saved, AnimatedScene content) {}

    /** @param failureListener hears, on the autosave thread, why the last edits could not be kept, whatever it was */
    public Autosave(RecoveryFolder recovery, Duration delay, Consumer<Throwable> failureListener) {
        this.recovery = recovery;
        this.delay = delay;
        this.failureListener = failureListener;
        thread = new ScheduledThreadPoolExecutor(1, DedicatedThread.factory("lightning-autosave"));
        thread.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
    }

    /** Tells of an edit, an undo or a save: call it after each. The text is made on the autosave thread. */
    public synchronized void documentChanged(OpenDocument document) {
        if (!document.isDirty()) {
            discard();
            return;
        }
        if (pending == null) {
            thread.schedule(this::write, delay.toMillis(), TimeUnit.MILLISECONDS);
        }
        pending = new PendingSave(document.file(), document.savedDocument(), document.content());
        savedFiles.add(document.file());
    }

    /** The document was saved, or closed on purpose: nothing of it needs to be kept, under whatever name it had. */
    public synchronized void discard() {
        pending = null;
        savedFiles.forEach(file -> thread.execute(() -> runOrReport(() -> recovery.delete(file))));
        savedFiles.clear();
    }

    /** Takes over what a crash left; see {@link RecoveryFolder#adopt}. */
    public synchronized void adopt(RecoveryFolder.RecoverableScene recoverable) {
        savedFiles.add(recoverable.file());
        thread.execute(() -> runOrReport(() -> recovery.adopt(recoverable)));
    }

    private void write() {
        PendingSave save;
        synchronized (this) {
            save = pending;
            pending = null;
        }
        if (save != null) {
            runOrReport(() -> recovery.store(save.file(), save.saved().withAnimatedScene(save.content()).text()));
        }
    }

    private interface FileOperation {
        void run() throws IOException;
    }

    private void runOrReport(FileOperation operation) {
        try {
            operation.run();
        } catch (Exception | Error e) {
            // The thread's executor would take anything else without a word.
            failureListener.accept(e);
        }
    }

    /** Finishes what was begun; edits that still wait are not written. */
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
