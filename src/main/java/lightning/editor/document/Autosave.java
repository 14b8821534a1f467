package lightning.editor.document;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashSet;
import java.util.Set;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import lightning.base.work.OwnThread;
import lightning.format.jen.JenDocument;
import lightning.scene.shot.AnimatedScene;

/**
 * Keeps unsaved edits on a thread of its own, a short while after the first of them, so that a crash loses no more than
 * that while. Safe for several threads.
 */
public final class Autosave implements AutoCloseable {
    /** With the time that writing takes, well below the five seconds that an artist may lose at most. */
    public static final Duration DEFAULT_DELAY = Duration.ofSeconds(2);

    private static final int PATIENCE_SECONDS = 5;

    private final Recovery recovery;
    private final Duration delay;
    private final Consumer<Throwable> trouble;
    private final ScheduledThreadPoolExecutor thread;
    private final Set<Path> kept = new HashSet<>();
    private Work waiting;

    private record Work(Path file, JenDocument saved, AnimatedScene content) {}

    /** @param trouble hears, on the autosave thread, why the last edits could not be kept, whatever it was */
    public Autosave(Recovery recovery, Duration delay, Consumer<Throwable> trouble) {
        this.recovery = recovery;
        this.delay = delay;
        this.trouble = trouble;
        thread = new ScheduledThreadPoolExecutor(1, OwnThread.named("lightning-autosave"));
        thread.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
    }

    /** Tells of an edit, an undo or a save: call it after each. The text is made on the autosave thread. */
    public synchronized void changed(OpenDocument document) {
        if (!document.isDirty()) {
            forget();
            return;
        }
        if (waiting == null) {
            thread.schedule(this::write, delay.toMillis(), TimeUnit.MILLISECONDS);
        }
        waiting = new Work(document.file(), document.savedText(), document.content());
        kept.add(document.file());
    }

    /** The document was saved, or closed on purpose: nothing of it needs to be kept, under whatever name it had. */
    public synchronized void forget() {
        waiting = null;
        kept.forEach(file -> thread.execute(() -> attempt(() -> recovery.forget(file))));
        kept.clear();
    }

    /** Takes over what a crash left; see {@link Recovery#adopt}. */
    public synchronized void adopt(Recovery.Found found) {
        kept.add(found.file());
        thread.execute(() -> attempt(() -> recovery.adopt(found)));
    }

    private void write() {
        Work work;
        synchronized (this) {
            work = waiting;
            waiting = null;
        }
        if (work != null) {
            attempt(() -> recovery.keep(work.file(), work.saved().with(work.content()).text()));
        }
    }

    private interface Step {
        void run() throws IOException;
    }

    private void attempt(Step step) {
        try {
            step.run();
        } catch (Exception | Error e) {
            // The thread's executor would take anything else without a word.
            trouble.accept(e);
        }
    }

    /** Finishes what was begun; edits that still wait are not written. */
    @Override
    public void close() {
        synchronized (this) {
            waiting = null;
        }
        thread.shutdown();
        try {
            thread.awaitTermination(PATIENCE_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
