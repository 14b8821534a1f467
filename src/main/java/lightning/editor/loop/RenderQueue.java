package lightning.editor.loop;

import lightning.base.work.Progress;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.Scene;

/**
 * Queue of a render loop. Keeps only the newest job of each kind, so that edits during a render cost one update, not one each. Thread-safe.
 */
final class RenderQueue {
    /** Job of the queue. */
    public sealed interface RenderJob {
        record Render(Scene scene) implements RenderJob {}

        record UpdateReflections() implements RenderJob {}

        /** Renders the missing anti-aliasing samples of the image. */
        record RenderSamples() implements RenderJob {}

        record Verify() implements RenderJob {}

        /** Drops the cache, for the document of that number. */
        record DropPicture(long number) implements RenderJob {}

        /** Displays the current image in another display mode. */
        public record Redisplay() implements RenderJob {}

        /** Switches the renderer's options, then renders {@code scene}; null if nothing was rendered yet. */
        record ChangeOptions(RenderOptions options, Scene scene) implements RenderJob {}
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

    private Scene scene;
    private RenderOptions options;
    private boolean reflectionsRequested;
    private boolean samplesRequested;
    private boolean verificationRequested;
    private boolean redisplayRequested;
    private boolean dropRequested;
    private long openedDocument;
    private boolean closed;
    private RenderJob running;
    private Scene rendered;
    private CancelSignal cancelSignal;

    synchronized void render(Scene requested) {
        scene = requested;
        if (requested != rendered) {
            postponeSamples();
        }
        if (isObsoleteFor(requested)) {
            // Reflections of the newer scene are still requested.
            reflectionsRequested |= running instanceof RenderJob.UpdateReflections;
            cancelSignal.cancel();
        }
        replaceRunning();
        notifyAll();
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
        if (scene != null && cancelSignal != null && cancelSignal.isReplaceable
                && !(running instanceof RenderJob.ChangeOptions || isRunning(scene))) {
            cancelSignal.preempt();
        }
    }

    private boolean isRunning(Scene requested) {
        return running instanceof RenderJob.Render r && r.scene() == requested;
    }

    /**
     * Tests if a running job is obsolete for a new scene. An update is not unless it is replaceable, or dragging would starve the image; a
     * first pass of another image is.
     */
    private boolean isObsoleteFor(Scene requested) {
        return switch (running) {
            case null -> false;
            case RenderJob.Render r -> !r.scene().hasSameView(requested);
            case RenderJob.ChangeOptions r -> r.scene() != null && !r.scene().hasSameView(requested);
            case RenderJob.UpdateReflections _ -> true;
            case RenderJob.RenderSamples _,RenderJob.Verify _,RenderJob.Redisplay _,RenderJob.DropPicture _ -> false;
        };
    }

    synchronized void requestReflections() {
        reflectionsRequested = true;
        notifyAll();
    }

    /** Requests the missing samples of the image, at the lowest priority. */
    synchronized void requestSamples() {
        samplesRequested = true;
        notifyAll();
    }

    /** Lets other jobs run before samples, whose start is not visible. */
    private void postponeSamples() {
        if (running instanceof RenderJob.RenderSamples) {
            samplesRequested = true;
            cancelSignal.preempt();
        }
    }

    synchronized void requestVerification() {
        verificationRequested = true;
        notifyAll();
    }

    synchronized void requestRedisplay() {
        redisplayRequested = true;
        postponeSamples();
        notifyAll();
    }

    /** Drops all pending work, running work and the cache for another document. */
    synchronized void open(Scene requested, long number) {
        cancel();
        dropRequested = true;
        openedDocument = number;
        render(requested);
    }

    synchronized void changeOptions(RenderOptions requested) {
        options = requested;
        postponeSamples();
        notifyAll();
    }

    /** Changes options and scene in one job, so that the old scene never appears with the new options. */
    synchronized void changeOptions(RenderOptions requested, Scene requestedScene) {
        changeOptions(requested);
        render(requestedScene);
    }

    /** Drops pending jobs and stops the running one. Returns true if a scene was pending; its cancellation is not reported elsewhere. */
    synchronized boolean cancel() {
        boolean wasWaiting = scene != null;
        scene = null;
        reflectionsRequested = false;
        samplesRequested = false;
        verificationRequested = false;
        if (cancelSignal != null) {
            cancelSignal.cancel();
        }
        return wasWaiting;
    }

    synchronized void close() {
        closed = true;
        cancel();
        notifyAll();
    }

    synchronized boolean isBusy() {
        return running != null || isWaiting();
    }

    /** Tests if a verification is pending or about to start. */
    synchronized boolean isVerifying() {
        return verificationRequested || running instanceof RenderJob.Verify;
    }

    private boolean isWaiting() {
        return scene != null || options != null || reflectionsRequested || redisplayRequested || samplesRequested || verificationRequested
                || dropRequested;
    }

    /** Waits for a job. Returns null when the queue is closed. */
    synchronized RenderJob take(CancelSignal newSignal) throws InterruptedException {
        while (!closed && !isWaiting()) {
            wait();
        }
        if (closed) {
            return null;
        }
        cancelSignal = newSignal;
        running = next();
        return running;
    }

    private RenderJob next() {
        if (dropRequested) {
            dropRequested = false;
            return new RenderJob.DropPicture(openedDocument);
        }
        if (options != null) {
            var job = new RenderJob.ChangeOptions(options, scene == null ? rendered : scene);
            options = null;
            scene = null;
            return job;
        }
        if (scene != null) {
            var job = new RenderJob.Render(scene);
            scene = null;
            return job;
        }
        if (reflectionsRequested) {
            reflectionsRequested = false;
            return new RenderJob.UpdateReflections();
        }
        if (redisplayRequested) {
            redisplayRequested = false;
            return new RenderJob.Redisplay();
        }
        if (samplesRequested) {
            samplesRequested = false;
            return new RenderJob.RenderSamples();
        }
        verificationRequested = false;
        return new RenderJob.Verify();
    }

    /**
     * Finishes the running job.
     *
     * @param nowRendered scene of the current image; null if none
     * @return true if no job is left
     */
    synchronized boolean finishJob(Scene nowRendered) {
        running = null;
        cancelSignal = null;
        rendered = nowRendered;
        return !isWaiting();
    }
}
