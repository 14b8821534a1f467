package lightning.shot;

import java.util.concurrent.CancellationException;
import lightning.base.text.Texts;

/** One frame after the other, for one lane of one keeper, until the queue is closed or the keeper is gone. */
record KeeperTurns(FrameQueue queue, int number, FrameQueue.Lane lane, FrameKeeper keeper, ShotListener listener) implements Runnable {
    @Override
    public void run() {
        try {
            for (FrameQueue.Work work = queue.take(number, lane); work != null; work = queue.take(number, lane)) {
                attempt(work);
                if (queue.end(work)) {
                    listener.idle();
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void attempt(FrameQueue.Work work) {
        try {
            FrameUpdate update = keeper.bring(work.frame, work.take, work);
            listener.updated(update, queue.made(work));
        } catch (CancellationException e) {
            // Something else is wanted.
        } catch (FrameRefusedException e) {
            if (queue.refuse(work)) {
                listener.failed(work.frame, new FrameRefusedException(Texts.of("nobody has room for it: {0}", e.getMessage())));
            }
        } catch (KeeperGoneException e) {
            if (queue.leave(number)) {
                listener.gone(e);
            }
        } catch (Throwable e) {
            // Whatever it is, the other frames go on.
            if (queue.fail(work)) {
                listener.failed(work.frame, e);
            }
        }
    }
}
