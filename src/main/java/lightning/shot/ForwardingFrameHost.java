package lightning.shot;

import java.util.Optional;
import lightning.base.work.Progress;
import lightning.render.image.Film;

/** Frame host that forwards every call to another one. Subclasses change what they need. */
public abstract class ForwardingFrameHost implements FrameHost {
    private final FrameHost host;

    protected ForwardingFrameHost(FrameHost host) {
        this.host = host;
    }

    @Override
    public FrameUpdate update(int frame, ShotRevision revision, Progress progress) throws HostLostException {
        return host.update(frame, revision, progress);
    }

    @Override
    public Optional<Film> film(int frame) {
        return host.film(frame);
    }

    @Override
    public Optional<Film> film(int frame, int maxWidth, int maxHeight) {
        return host.film(frame, maxWidth, maxHeight);
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
