package lightning.editor.loop;

import java.util.concurrent.CancellationException;
import lightning.scene.Scene;

/** One work of a queue after the other, until it is closed: what the thread of a render loop does. Knows no renderer. */
final class RenderJobRunner implements Runnable {
    /** Does the work of the queue. Called on the thread alone. */
    interface RenderJobHandler extends AutoCloseable {
        /**
         * Does one work and tells of what came of it.
         *
         * @throws CancellationException if {@code signal} was asked for; the picture is then as before
         */
        void handle(RenderQueue.RenderJob job, RenderQueue.CancelSignal signal);

        /** The scene that the picture shows now; null before the first. */
        Scene renderedScene();

        /** Nothing is left to do, and that was told. */
        void becomeIdle();

        @Override
        void close();
    }

    private final RenderQueue queue;
    private final RenderJobHandler handler;
    private final RenderListener listener;

    RenderJobRunner(RenderQueue queue, RenderJobHandler handler, RenderListener listener) {
        this.queue = queue;
        this.handler = handler;
        this.listener = listener;
    }

    @Override
    public void run() {
        try (handler) {
            while (true) {
                var signal = new RenderQueue.CancelSignal(listener::progress);
                RenderQueue.RenderJob job = queue.take(signal);
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

    private void tryJob(RenderQueue.RenderJob job, RenderQueue.CancelSignal signal) {
        try {
            handler.handle(job, signal);
        } catch (CancellationException e) {
            if (!signal.isPreempted()) {
                listener.canceled();
            }
        } catch (Throwable e) {
            // Whatever it is, the window lives on and says so.
            listener.failed(e);
        }
    }
}
