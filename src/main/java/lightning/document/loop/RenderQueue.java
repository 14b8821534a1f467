package lightning.document.loop;

import static java.util.Objects.requireNonNull;

import java.time.Duration;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Queue of a render loop. Keeps only the newest job of each kind, so that edits during a render cost one update, not one each. Thread-safe.
 */
final class RenderQueue {
    /** Job of the queue. */
    public sealed interface Job {
        record Render(Scene scene) implements Job {}

        record UpdateReflections() implements Job {}

        /** Renders the missing anti-aliasing samples of the image. */
        record RenderSamples() implements Job {}

        record Verify() implements Job {}

        /** Drops the cache, for the document of that number; first keeps its image if that was requested. */
        record DropPicture(long number, boolean keepsFirst) implements Job {}

        /** Keeps the current image for later processes. */
        record KeepPicture() implements Job {}

        /** Displays the current image in another display mode. */
        public record Redisplay() implements Job {}

        /** Switches the renderer's options, then renders {@code scene}; null if nothing was rendered yet. */
        record ChangeOptions(RenderOptions options, @Nullable Scene scene) implements Job {}

        /** Returns the slot in which it waits. */
        private Slot slot() {
            return switch (this) {
                case DropPicture _ -> Slot.DROP;
                case ChangeOptions _ -> Slot.OPTIONS;
                case Render _ -> Slot.SCENE;
                case UpdateReflections _ -> Slot.REFLECTIONS;
                case Redisplay _ -> Slot.DISPLAY;
                case RenderSamples _ -> Slot.SAMPLES;
                case Verify _ -> Slot.VERIFICATION;
                case KeepPicture _ -> Slot.KEEPING;
            };
        }
    }

    /** Places of waiting jobs, one for each kind, in the order in which they run. */
    private enum Slot {
        DROP,
        OPTIONS,
        SCENE,
        REFLECTIONS,
        DISPLAY,
        SAMPLES,
        VERIFICATION,
        KEEPING
    }

    /** Listener for the progress of a job. */
    interface TileListener {
        void tiles(int done, int total);

        default void rays(long count) {}
    }

    /** Cancellation signal of one job. */
    static final class CancelSignal implements Progress {
        private final TileListener listener;
        private volatile boolean canceled;
        private volatile boolean preempted;
        /** True while a newer scene replaces the job. Guarded by the queue. */
        private boolean isReplaceable;

        CancelSignal(TileListener listener) {
            this.listener = listener;
        }

        void cancel() {
            preempted = false;
            canceled = true;
        }

        /** Stops a job that resumes after another one, without reporting a cancellation. */
        void preempt() {
            preempted = !canceled;
            canceled = true;
        }

        boolean isPreempted() {
            return preempted;
        }

        @Override
        public void report(int done, int total) {
            listener.tiles(done, total);
        }

        @Override
        public void raysCast(long count) {
            listener.rays(count);
        }

        @Override
        public boolean isCanceled() {
            return canceled;
        }
    }

    /** Newest waiting job of each kind. A change of options gets its scene when it starts. */
    private final Map<Slot, Job> waiting = new EnumMap<>(Slot.class);
    private boolean closed;
    private @Nullable Job running;
    private @Nullable Scene rendered;
    private @Nullable CancelSignal cancelSignal;
    /** True from an interruption of samples until samples are finished, and when the last job ended. */
    private boolean wereSamplesInterrupted;
    private long endedNs = System.nanoTime();
    private final Duration pause;

    /** @param pause time without an edit before samples that an edit interrupted start again, so that they do not slow down a drag */
    RenderQueue(Duration pause) {
        this.pause = pause;
    }

    private void add(Job job) {
        if (!closed) {
            waiting.put(job.slot(), job);
            notifyAll();
        }
    }

    /** Returns the scene that waits; null if none does. */
    private @Nullable Scene waitingScene() {
        return waiting.get(Slot.SCENE) instanceof Job.Render r ? r.scene() : null;
    }

    /** Returns the scene that waits and has the view of another; null if none does. */
    synchronized @Nullable Scene waitingScene(Scene sameView) {
        Scene scene = waitingScene();
        return scene != null && scene.hasSameView(sameView) ? scene : null;
    }

    synchronized void render(Scene requested) {
        add(new Job.Render(requested));
        if (requested != rendered) {
            postponeSamples();
        }
        if (isObsoleteFor(requested)) {
            if (running instanceof Job.UpdateReflections) {
                // Reflections of the newer scene are still requested.
                add(running);
            }
            requireNonNull(cancelSignal).cancel();
        }
        replaceRunning();
    }

    /**
     * Sets whether a newer scene replaces a running job without waiting for it, as the display already shows the job's scene coarsely.
     *
     * @param signal signal of the job
     */
    synchronized void setReplaceable(CancelSignal signal, boolean isReplaceable) {
        signal.isReplaceable = isReplaceable;
        if (signal == cancelSignal) {
            replaceRunning();
        }
    }

    private void replaceRunning() {
        if (waiting.containsKey(Slot.SCENE) && cancelSignal != null && cancelSignal.isReplaceable
                && !(running instanceof Job.ChangeOptions || isRunning(waitingScene()))) {
            requireNonNull(cancelSignal).preempt();
        }
    }

    private boolean isRunning(@Nullable Scene requested) {
        return running instanceof Job.Render r && r.scene() == requested;
    }

    /**
     * Returns whether a running job is obsolete for a new scene. An update is not unless it is replaceable, or dragging would starve the image; a
     * first pass of another image is.
     */
    private boolean isObsoleteFor(Scene requested) {
        return switch (running) {
            case null -> false;
            case Job.Render r -> !r.scene().hasSameView(requested);
            case Job.ChangeOptions r -> r.scene() != null && !r.scene().hasSameView(requested);
            case Job.UpdateReflections _ -> true;
            case Job.RenderSamples _,Job.Verify _,Job.Redisplay _,Job.DropPicture _,Job.KeepPicture _ -> false;
        };
    }

    synchronized void requestReflections() {
        add(new Job.UpdateReflections());
    }

    /** Requests the missing samples of the image, at the lowest priority. */
    synchronized void requestSamples() {
        add(new Job.RenderSamples());
    }

    /** Lets other jobs run before samples, whose start is not visible. */
    private void postponeSamples() {
        if (running instanceof Job.RenderSamples) {
            add(running);
            wereSamplesInterrupted = true;
            requireNonNull(cancelSignal).preempt();
        }
    }

    synchronized void requestVerification() {
        add(new Job.Verify());
    }

    synchronized void requestKeeping() {
        add(new Job.KeepPicture());
    }

    synchronized void requestRedisplay() {
        add(new Job.Redisplay());
        postponeSamples();
    }

    /** Drops all pending work, running work and the cache for another document. */
    synchronized void open(Scene requested, long number) {
        boolean keepsFirst = isKeepingRequested();
        cancel();
        add(new Job.DropPicture(number, keepsFirst));
        render(requested);
    }

    /** Returns whether the current image waits to be kept, alone or before it is dropped. */
    private boolean isKeepingRequested() {
        return waiting.containsKey(Slot.KEEPING) || waiting.get(Slot.DROP) instanceof Job.DropPicture d && d.keepsFirst();
    }

    synchronized void changeOptions(RenderOptions requested) {
        add(new Job.ChangeOptions(requested, null));
        postponeSamples();
    }

    /** Changes options and scene in one job, so that the old scene never appears with the new options. */
    synchronized void changeOptions(RenderOptions requested, Scene requestedScene) {
        changeOptions(requested);
        render(requestedScene);
    }

    /** Drops pending jobs and stops the running one. Returns whether a scene was pending; its cancellation is not reported elsewhere. */
    synchronized boolean cancel() {
        boolean wasWaiting = waiting.containsKey(Slot.SCENE);
        waiting.keySet().removeAll(EnumSet.of(Slot.SCENE, Slot.REFLECTIONS, Slot.SAMPLES, Slot.VERIFICATION, Slot.KEEPING));
        if (cancelSignal != null) {
            cancelSignal.cancel();
        }
        return wasWaiting;
    }

    /** Ends {@link #take}, after a requested keeping of the image. */
    synchronized void close() {
        boolean keeps = isKeepingRequested();
        cancel();
        waiting.clear();
        if (keeps) {
            add(new Job.KeepPicture());
        }
        closed = true;
        notifyAll();
    }

    synchronized boolean isBusy() {
        return running != null || !waiting.isEmpty();
    }

    /** Returns whether a verification is pending or about to start. */
    synchronized boolean isVerifying() {
        return waiting.containsKey(Slot.VERIFICATION) || running instanceof Job.Verify;
    }

    /** Waits for a job. Returns null when the queue is closed and no image is to be kept. */
    synchronized @Nullable Job take(CancelSignal newSignal) throws InterruptedException {
        while (!closed && waiting.isEmpty()) {
            wait();
        }
        for (long rest = pauseMs(); !closed && rest > 0; rest = pauseMs()) {
            wait(rest);
        }
        if (waiting.isEmpty()) {
            return null;
        }
        cancelSignal = newSignal;
        running = next();
        return running;
    }

    /** Returns how many milliseconds the waiting samples pause; at most 0 if another job waits, too. */
    private long pauseMs() {
        boolean waits = wereSamplesInterrupted && !waiting.isEmpty() && !waiting.containsKey(Slot.VERIFICATION)
                && waiting.keySet().iterator().next() == Slot.SAMPLES;
        return waits ? pause.minusNanos(System.nanoTime() - endedNs).toMillis() : 0;
    }

    private @Nullable Job next() {
        Job first = waiting.remove(waiting.keySet().iterator().next());
        if (first instanceof Job.ChangeOptions change) {
            Scene scene = waitingScene();
            waiting.remove(Slot.SCENE);
            return new Job.ChangeOptions(change.options(), scene == null ? rendered : scene);
        }
        return first;
    }

    /**
     * Finishes the running job.
     *
     * @param nowRendered scene of the current image; null if none
     * @return true if no job is left
     */
    synchronized boolean finishJob(@Nullable Scene nowRendered) {
        wereSamplesInterrupted &= !(running instanceof Job.RenderSamples) || requireNonNull(cancelSignal).isPreempted();
        endedNs = System.nanoTime();
        running = null;
        cancelSignal = null;
        rendered = nowRendered;
        return waiting.isEmpty();
    }
}
