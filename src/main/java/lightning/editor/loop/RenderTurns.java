package lightning.editor.loop;

import java.util.concurrent.CancellationException;
import lightning.scene.Scene;

/** One work of a queue after the other, until it is closed: what the thread of a render loop does. Knows no renderer. */
final class RenderTurns implements Runnable {
    /** Does the work of the queue. Called on the thread alone. */
    interface WorkHandler extends AutoCloseable {
        /**
         * Does one work and tells of what came of it.
         *
         * @throws CancellationException if {@code stop} was asked for; the picture is then as before
         */
        void work(RenderQueue.Work work, RenderQueue.Stop stop);

        /** The scene that the picture shows now; null before the first. */
        Scene rendered();

        /** Nothing is left to do, and that was told. */
        void rest();

        @Override
        void close();
    }

    private final RenderQueue queue;
    private final WorkHandler handler;
    private final RenderListener listener;

    RenderTurns(RenderQueue queue, WorkHandler handler, RenderListener listener) {
        this.queue = queue;
        this.handler = handler;
        this.listener = listener;
    }

    @Override
    public void run() {
        try (handler) {
            while (true) {
                var stop = new RenderQueue.Stop(listener::progress);
                RenderQueue.Work work = queue.take(stop);
                if (work == null) {
                    return;
                }
                attempt(work, stop);
                if (queue.done(handler.rendered())) {
                    listener.idle();
                    handler.rest();
                } else {
                    listener.goesOn();
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void attempt(RenderQueue.Work work, RenderQueue.Stop stop) {
        try {
            handler.work(work, stop);
        } catch (CancellationException e) {
            if (!stop.gaveWay()) {
                listener.cancelled();
            }
        } catch (Throwable e) {
            // Whatever it is, the window lives on and says so.
            listener.failed(e);
        }
    }
}
