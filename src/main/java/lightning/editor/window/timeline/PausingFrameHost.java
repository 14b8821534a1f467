package lightning.editor.window.timeline;

import java.util.function.BooleanSupplier;
import lightning.base.work.Progress;
import lightning.shot.ForwardingFrameHost;
import lightning.shot.FrameHost;
import lightning.shot.FrameUpdate;
import lightning.shot.HostLostException;
import lightning.shot.ShotRevision;

/** Frame host that pauses between two tiles while more urgent work runs. */
final class PausingFrameHost extends ForwardingFrameHost {
    private static final long PAUSE_MS = 5;

    private final BooleanSupplier shouldPause;

    /** @param shouldPause called on the host's threads */
    PausingFrameHost(FrameHost host, BooleanSupplier shouldPause) {
        super(host);
        this.shouldPause = shouldPause;
    }

    @Override
    public FrameUpdate update(int frame, ShotRevision take, Progress progress) throws HostLostException {
        return super.update(frame, take, new Progress() {
            @Override
            public void report(int done, int total) {
                progress.report(done, total);
            }

            @Override
            public boolean isCanceled() {
                while (shouldPause.getAsBoolean() && !progress.isCanceled()) {
                    try {
                        Thread.sleep(PAUSE_MS);
                    } catch (InterruptedException e) {
                        Thread.currentThread().interrupt();
                        return true;
                    }
                }
                return progress.isCanceled();
            }
        });
    }
}
