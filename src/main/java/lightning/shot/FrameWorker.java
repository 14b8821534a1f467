package lightning.shot;

import java.util.concurrent.CancellationException;
import lightning.base.text.Messages;

/** One frame after the other, for one lane of one keeper, until the queue is closed or the keeper is gone. */
record FrameWorker(FrameQueue queue, int hostIndex, FrameQueue.Lane lane, FrameHost host, ShotListener listener) implements Runnable {
    @Override
    public void run() {
        try {
            for (FrameQueue.Job job = queue.nextJob(hostIndex, lane); job != null; job = queue.nextJob(hostIndex, lane)) {
                process(job);
                if (queue.finish(job)) {
                    listener.shotIdle();
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void process(FrameQueue.Job job) {
        try {
            FrameUpdate update = host.update(job.frame, job.revision, job);
            listener.frameUpdated(update, queue.complete(job));
        } catch (CancellationException e) {
            // Something else is wanted.
        } catch (FrameRejectedException e) {
            if (queue.reject(job)) {
                listener.frameFailed(job.frame,
                        new FrameRejectedException(Messages.tr("no node has enough memory for it: {0}", e.getMessage())));
            }
        } catch (HostLostException e) {
            if (queue.removeHost(hostIndex)) {
                listener.hostLost(e);
            }
        } catch (Throwable e) {
            // Whatever it is, the other frames go on.
            if (queue.markFailed(job)) {
                listener.frameFailed(job.frame, e);
            }
        }
    }
}
