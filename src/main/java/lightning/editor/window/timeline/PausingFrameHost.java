package lightning.editor.window.timeline;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import lightning.base.work.Progress;
import lightning.render.image.Film;
import lightning.shot.CacheUsage;
import lightning.shot.FrameHost;
import lightning.shot.FrameUpdate;
import lightning.shot.HostLostException;
import lightning.shot.ShotRevision;

/**
 * Frame host that pauses between two tiles while more urgent work runs.
 *
 * @param shouldPause called on the host's threads
 */
record PausingFrameHost(FrameHost host, BooleanSupplier shouldPause) implements FrameHost {
    private static final long PAUSE_MS = 5;

    @Override
    public FrameUpdate update(int frame, ShotRevision take, Progress progress) throws HostLostException {
        return host.update(frame, take, new Progress() {
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

    @Override
    public Optional<Film> film(int frame) {
        return host.film(frame);
    }

    @Override
    public void focus(int frame) {
        host.focus(frame);
    }

    @Override
    public void drop(int frame) {
        host.drop(frame);
    }

    @Override
    public CacheUsage usage() {
        return host.usage();
    }

    @Override
    public void close() {
        host.close();
    }
}
