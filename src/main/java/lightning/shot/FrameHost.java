package lightning.shot;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.render.image.Downscale;
import lightning.render.image.Film;

/**
 * What holds frames: the caches of some of them, from which it relights. Here in this process ({@link LocalFrameHost}), or anywhere else:
 * a scene, its keys and a frame's number go there, and a film comes back.
 *
 * <p>Two threads of {@link ShotRelighter} call {@link #update} at once, never for the same frame; all else is called from any thread. Which
 * frame is next, and who is told, is not its affair.
 */
public interface FrameHost extends AutoCloseable {
    /**
     * Makes a frame show a take: relights what is kept of the frame as far as that serves, and traces what does not. The film has the
     * bits of a full trace of {@link ShotRevision#sceneAt}, whatever was kept.
     *
     * @param progress asked before each tile; it may keep its caller waiting while something is more urgent
     * @throws CancellationException                if {@code progress} asked to stop; what is kept is as before
     * @throws IllegalArgumentException             if the take has no such frame, or its scene cannot be
     * @throws lightning.render.relight.PictureTooLargeException    if it does not fit into memory
     * @throws FrameRejectedException                if it cannot be held here; nothing is kept of it, and others are asked
     * @throws HostLostException                  if frames are held here no more; nobody asks again
     */
    FrameUpdate update(int frame, ShotRevision revision, Progress progress) throws HostLostException;

    /** The film that {@link #update} made last; empty where nothing is kept. */
    Optional<Film> film(int frame);

    /**
     * The same, made smaller so as to have room: see {@link Downscale#fit}.
     *
     * @param maxWidth pixels, ≥ 1; likewise {@code maxHeight}
     */
    default Optional<Film> film(int frame, int maxWidth, int maxHeight) {
        return film(frame).map(film -> Downscale.fit(film.width(), film.height(), maxWidth, maxHeight).apply(film));
    }

    /** Tells which frame is looked at: those near it are wanted first, so they are kept where they are at hand. */
    void focus(int frame);

    /** Drops what is kept of a frame. */
    void drop(int frame);

    /** What is kept. */
    CacheUsage usage();

    /** Drops all; nobody is in {@link #update} by then. */
    @Override
    void close();
}
