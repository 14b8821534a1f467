package lightning.shot;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.render.image.Downscale;
import lightning.render.image.Film;

/**
 * What holds frames: the caches of some of them, from which it relights. Here in this process ({@link LocalKeeper}), or anywhere else:
 * a scene, its keys and a frame's number go there, and a film comes back.
 *
 * <p>Two threads of {@link RelitShot} call {@link #bring} at once, never for the same frame; all else is called from any thread. Which
 * frame is next, and who is told, is not its affair.
 */
public interface FrameKeeper extends AutoCloseable {
    /**
     * Makes a frame show a take: relights what is kept of the frame as far as that serves, and traces what does not. The film has the
     * bits of a full trace of {@link Take#at}, whatever was kept.
     *
     * @param progress asked before each tile; it may keep its caller waiting while something is more urgent
     * @throws CancellationException                if {@code progress} asked to stop; what is kept is as before
     * @throws IllegalArgumentException             if the take has no such frame, or its scene cannot be
     * @throws lightning.render.relight.PictureTooLarge    if it does not fit into memory
     * @throws FrameRefusedException                if it cannot be held here; nothing is kept of it, and others are asked
     * @throws KeeperGoneException                  if frames are held here no more; nobody asks again
     */
    FrameUpdate bring(int frame, Take take, Progress progress) throws KeeperGoneException;

    /** The film that {@link #bring} made last; empty where nothing is kept. */
    Optional<Film> film(int frame);

    /**
     * The same, made smaller so as to have room: see {@link Downscale#into}.
     *
     * @param mostWidth pixels, ≥ 1; likewise {@code mostHeight}
     */
    default Optional<Film> film(int frame, int mostWidth, int mostHeight) {
        return film(frame).map(film -> Downscale.into(film.width(), film.height(), mostWidth, mostHeight).of(film));
    }

    /** Tells which frame is looked at: those near it are wanted first, so they are kept where they are at hand. */
    void focus(int frame);

    /** Drops what is kept of a frame. */
    void forget(int frame);

    /** What is kept. */
    KeptBytes bytes();

    /** Drops all; nobody is in {@link #bring} by then. */
    @Override
    void close();
}
