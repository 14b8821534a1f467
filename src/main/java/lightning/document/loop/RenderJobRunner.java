package lightning.document.loop;

import java.util.concurrent.CancellationException;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Runs the jobs of a queue one after the other on the thread of a render loop, until the queue is closed. Independent of the renderer. */
record RenderJobRunner(RenderQueue queue, RenderJobHandler handler, RenderListener listener) implements Runnable {
    /** Handler of the queue's jobs. Called on the loop's thread only. */
    interface RenderJobHandler extends AutoCloseable {
        /**
         * Runs one job and reports its result.
         *
         * @throws CancellationException if {@code signal} was canceled; the image is then unchanged
         */
        void handle(RenderQueue.Job job, RenderQueue.CancelSignal signal);

        /** Returns the scene of the current image; null before the first. */
        @Nullable
        Scene renderedScene();

        /** Reports that no job is left. */
        void becomeIdle();

        @Override
        void close();
    }

    /** Forwards a job's progress. */
    private record ProgressReport(RenderListener listener) implements RenderQueue.TileListener {
        @Override
        public void tiles(int done, int total) {
            listener.progress(done, total);
        }

        @Override
        public void rays(long count) {
            listener.raysCast(count);
        }
    }

    @Override
    public void run() {
        try (handler) {
            while (true) {
                var signal = new RenderQueue.CancelSignal(new ProgressReport(listener));
                RenderQueue.Job job = queue.take(signal);
                if (job == null) {
                    return;
                }
                tryJob(job, signal);
                if (queue.finishJob(handler.renderedScene())) {
                    listener.idle();
                    handler.becomeIdle();
                } else {
                    listener.workRemaining();
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void tryJob(RenderQueue.Job job, RenderQueue.CancelSignal signal) {
        try {
            handler.handle(job, signal);
        } catch (CancellationException e) {
            if (!signal.isPreempted()) {
                listener.canceled();
            }
        } catch (Throwable e) {
            // Reports any failure; the window stays open.
            listener.failed(e);
        }
    }
}
