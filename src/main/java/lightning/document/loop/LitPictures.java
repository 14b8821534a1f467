package lightning.document.loop;

import java.util.Optional;
import java.util.concurrent.locks.ReentrantLock;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.trace.Geometry;
import lightning.scene.GatherSettings;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Small pictures of edited scenes with all their light. The first one takes about a second; each further one is computed from the last, like any
 * picture, in a quarter of that. Thread-safe: while one thread computes a picture, others get none.
 */
final class LitPictures implements AutoCloseable {
    /** Longer side in pixels. */
    private static final int SIDE = 96;
    /** Usual share of an update in the time of a first picture. */
    private static final double UPDATE_SHARE = 0.25;

    private final ReentrantLock lock = new ReentrantLock();
    private final RenderOptions options;
    /** Null before the first picture. */
    private @Nullable Renderer renderer;
    private @Nullable Scene scene;
    private @Nullable Film film;
    /** Time of the last picture, seconds; an estimate after the first. */
    private double seconds;

    LitPictures(RenderOptions options) {
        this.options = options;
    }

    /** Returns whether pictures of a scene show light that coarse images lack. */
    static boolean areUseful(Scene scene) {
        return GatherSettings.of(scene).isPresent();
    }

    /**
     * Computes the first picture, if there is none of the same camera and size.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} requested to stop
     */
    void prepare(Scene first, Geometry geometry, Progress progress) {
        lock.lock();
        try {
            if (!hasView(first) && areUseful(first)) {
                clear();
                renderer = new Renderer(options);
                renderer.setSharedGeometry(geometry);
                trace(renderer, first, progress);
                seconds *= UPDATE_SHARE;
            }
        } finally {
            lock.unlock();
        }
    }

    private boolean hasView(Scene other) {
        return scene != null && EditPreview.isSameView(scene, other);
    }

    /**
     * Returns the time of the next picture in seconds, as that of the last one; +∞ if there was none with the camera and the size of a scene, or
     * another thread computes one.
     */
    double expectedSeconds(Scene before) {
        if (!lock.tryLock()) {
            return Double.POSITIVE_INFINITY;
        }
        try {
            return hasView(before) ? seconds : Double.POSITIVE_INFINITY;
        } finally {
            lock.unlock();
        }
    }

    /**
     * Returns the picture of a scene; empty before the first, or if another thread computes one.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} requested to stop
     */
    Optional<Film> of(Scene target, Progress progress) {
        if (!lock.tryLock()) {
            return Optional.empty();
        }
        try {
            return renderer == null ? Optional.empty()
                    : Optional.of(target == scene && film != null ? film : trace(renderer, target, progress));
        } finally {
            lock.unlock();
        }
    }

    private Film trace(Renderer with, Scene target, Progress progress) {
        long start = System.nanoTime();
        with.renderCenters(with.plan(shrunk(target)), progress.cancellationOnly());
        Film traced = with.film().copy();
        film = traced;
        scene = target;
        seconds = (System.nanoTime() - start) / 1e9;
        return traced;
    }

    /** Forgets all pictures. */
    void clear() {
        lock.lock();
        try {
            if (renderer != null) {
                renderer.close();
            }
            renderer = null;
            scene = null;
            film = null;
        } finally {
            lock.unlock();
        }
    }

    private static Scene shrunk(Scene scene) {
        PictureSettings picture = scene.picture();
        double shrink = Math.max(1, Math.max(picture.width(), picture.height()) / (double) SIDE);
        return scene
                .withPicture(picture.withSize(Math.max(1, (int) (picture.width() / shrink)), Math.max(1, (int) (picture.height() / shrink)))
                        .withSampling(SamplingSettings.DEFAULT));
    }

    @Override
    public void close() {
        clear();
    }
}
