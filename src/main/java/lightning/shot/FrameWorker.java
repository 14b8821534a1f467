package lightning.shot;

import java.util.concurrent.CancellationException;
import lightning.base.text.Messages;

/** Worker loop for one lane of a host: runs jobs until the queue is closed or the host is gone. */
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
            // The job was canceled for more urgent work.
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
            // Any other failure concerns only this frame.
            if (queue.markFailed(job)) {
                listener.frameFailed(job.frame, e);
            }
        }
    }
}
