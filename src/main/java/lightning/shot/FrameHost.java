package lightning.shot;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.render.image.Downscale;
import lightning.render.image.Film;

/**
 * Owner of frames: keeps the caches of some frames and relights them. A host may run in this process ({@link LocalFrameHost}) or elsewhere:
 * it receives a scene, its keyframes and a frame number, and returns a film.
 *
 * <p>Two threads of {@link ShotRelighter} call {@link #update} concurrently, never for the same frame; any thread may call the other
 * methods. Scheduling and notification are not the host's task.
 */
public interface FrameHost extends AutoCloseable {
    /**
     * Updates a frame to a revision: relights its cache as far as possible and traces the rest. The film has the bits of a full trace of
     * {@link ShotRevision#sceneAt}, whatever the cache held.
     *
     * @param progress polled before each tile; may block while more urgent work runs
     * @throws CancellationException                if {@code progress} canceled the update; the cache is then unchanged
     * @throws IllegalArgumentException             if the revision has no such frame, or its scene is invalid
     * @throws lightning.render.relight.PictureTooLargeException    if it does not fit into memory
     * @throws FrameRejectedException                if this host cannot keep it; keeps nothing of the frame, and other hosts are tried
     * @throws HostLostException                  if the host is gone; it is not called again
     */
    FrameUpdate update(int frame, ShotRevision revision, Progress progress) throws HostLostException;

    /** Returns the film of the last {@link #update}; empty if it is not cached. */
    Optional<Film> film(int frame);

    /**
     * Returns the last film, downscaled to fit: see {@link Downscale#fit}.
     *
     * @param maxWidth  pixels, ≥ 1
     * @param maxHeight pixels, ≥ 1
     */
    default Optional<Film> film(int frame, int maxWidth, int maxHeight) {
        return film(frame).map(film -> Downscale.fit(film.width(), film.height(), maxWidth, maxHeight).apply(film));
    }

    /** Sets the focused frame; frames near it are kept in the fastest storage. */
    void focus(int frame);

    /** Drops the cache of a frame. */
    void drop(int frame);

    /** Returns the cache usage. */
    CacheUsage usage();

    /** Drops all caches; no {@link #update} may be running. */
    @Override
    void close();
}
