package lightning.serve;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.CancellationException;

/** Order in which scenes are rendered: one at a time, each with all processors, first come, first served. A canceled request leaves. */
final class RenderTurn {
    private final Deque<Request> waiting = new ArrayDeque<>();

    /**
     * Waits for the turn of a request; the caller calls {@link #release} later.
     *
     * @throws CancellationException if it is canceled while it waits
     */
    synchronized void await(Request request) {
        waiting.add(request);
        try {
            while (waiting.peek() != request && !request.isCanceled()) {
                wait();
            }
        } catch (InterruptedException e) {
            request.cancel();
        }
        if (request.isCanceled()) {
            release(request);
            throw new CancellationException();
        }
    }

    synchronized void release(Request request) {
        waiting.remove(request);
        notifyAll();
    }

    /** Lets canceled requests leave. */
    synchronized void wake() {
        notifyAll();
    }
}
