package lightning.editor.loop;

import lightning.base.work.Progress;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.Scene;

/**
 * What a render loop shall do next: of each kind of work the newest, so that edits made while a picture is rendered cost
 * one update and not one each. Safe for several threads.
 */
final class RenderQueue {
    /** One piece of work. */
    public sealed interface RenderJob {
        record Render(Scene scene) implements RenderJob {}

        record UpdateReflections() implements RenderJob {}

        /** The finer samples that a picture lacks. */
        record RenderSamples() implements RenderJob {}

        record Verify() implements RenderJob {}

        /** All that is known of the picture is dropped for a document of that number. */
        record DropPicture(long number) implements RenderJob {}

        /** The picture that there is, to be looked at in another way. */
        public record Redisplay() implements RenderJob {}

        /** Another renderer, then {@code scene}; null where nothing was rendered yet. */
        record ChangeOptions(RenderOptions options, Scene scene) implements RenderJob {}
    }

    /** Hears how far it is. */
    interface TileListener {
        void tiles(int done, int total);
    }

    /** Stops one piece of work. */
    static final class CancelSignal implements Progress {
        private final TileListener listener;
        private volatile boolean canceled;
        private volatile boolean preempted;

        CancelSignal(TileListener listener) {
            this.listener = listener;
        }

        void cancel() {
            preempted = false;
            canceled = true;
        }

        /** Stops a work that is taken up again after another: nobody needs to hear of it. */
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
            // The mirrors are still wanted, of the newer scene.
            reflectionsRequested |= running instanceof RenderJob.UpdateReflections;
            cancelSignal.cancel();
        }
        notifyAll();
    }

    /** An update is left to finish, or dragging would starve the picture; a trace of another picture is not. */
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

    /** The picture lacks samples: they are made when nothing else of it is to be done. */
    synchronized void requestSamples() {
        samplesRequested = true;
        notifyAll();
    }

    /** Other work comes before samples, which nobody can see to be begun. */
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

    /** What waits, what runs and what is known is of no use any more. */
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

    /** At once, so that nobody sees the old scene in the new way between. */
    synchronized void changeOptions(RenderOptions requested, Scene requestedScene) {
        changeOptions(requested);
        render(requestedScene);
    }

    /** Forgets what waits and stops what runs; returns whether a scene waited, of which nobody else hears. */
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

    /** Whether a verification waits or is about to be handed on. */
    synchronized boolean isVerifying() {
        return verificationRequested || running instanceof RenderJob.Verify;
    }

    private boolean isWaiting() {
        return scene != null || options != null || reflectionsRequested || redisplayRequested || samplesRequested || verificationRequested
                || dropRequested;
    }

    /** Waits for work; returns null when the queue was closed. */
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
     * The work is over.
     *
     * @param nowRendered the scene that the picture shows now; null where there is none
     * @return whether nothing is left
     */
    synchronized boolean finishJob(Scene nowRendered) {
        running = null;
        cancelSignal = null;
        rendered = nowRendered;
        return !isWaiting();
    }
}
