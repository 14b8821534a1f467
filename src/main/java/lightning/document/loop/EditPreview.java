package lightning.document.loop;

import java.util.Optional;
import lightning.base.work.Progress;
import lightning.render.cache.PixelCache;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.shading.RenderedScenes;
import lightning.render.trace.Geometry;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Quick previews of edited scenes: the last picture, changed where coarse pictures of the scenes before and after the edit differ
 * ({@link EditEstimate}), so that the rest stays sharp. Thread-safe.
 */
final class EditPreview implements AutoCloseable {
    /** Time for a coarse picture, which precedes each step of a slow drag, in seconds. */
    private static final double SECONDS = 0.06;
    /** Longest time of a preview with all light that precedes each step of a drag, in seconds. */
    private static final double MAX_LIT_SECONDS = 0.4;
    /** Pixels of pictures that take several times as long as such a preview. */
    private static final int MIN_LIT_PIXELS = 100_000;

    /**
     * Last picture, its scenes and its shapes.
     *
     * @param film     picture
     * @param scenes   scene of the picture, and scene of its reflections
     * @param geometry primitives and BVH of the scene
     */
    record Before(Film film, RenderedScenes scenes, Geometry geometry) {}

    /**
     * Coarse picture of the scenes before an edit, which all steps of a drag share.
     *
     * @param pixels requested number of pixels, which decides the picture's size
     */
    private record CoarseBefore(RenderedScenes scenes, int pixels, CoarsePicture picture) {
        boolean shows(RenderedScenes other) {
            return scenes.scene() == other.scene() && scenes.mirrored() == other.mirrored();
        }
    }

    private final Renderer renderer;
    /** Pixels that all threads trace per second. */
    private double pixelsPerSecond;
    private @Nullable CoarseBefore lastBefore;
    private final LitPictures litPictures;
    /** Small picture with all light of the scene before an edit, which all steps of a drag share. */
    private @Nullable LitBefore litBefore;

    private record LitBefore(Scene scene, Film film) {}

    EditPreview(Renderer renderer) {
        this.renderer = renderer;
        litPictures = new LitPictures(renderer.options());
    }

    /** Prepares previews with all light of edits of a picture, as {@link LitPictures#prepare}. */
    void prepareLit(PixelCache picture, Progress progress) {
        litPictures.prepare(picture.scene(), picture.geometry(), progress);
    }

    /** Returns whether a preview with all light is worth its time for an update that traces paths of light again. */
    boolean canBeLit(Before before, RenderedScenes after) {
        PictureSettings picture = after.scene().picture();
        return isSameView(before.scenes().scene(), after.scene()) && after.mirrored() == after.scene()
                && picture.width() * (long) picture.height() >= MIN_LIT_PIXELS
                && litPictures.expectedSeconds(before.scenes().scene()) <= MAX_LIT_SECONDS;
    }

    /**
     * Returns a preview with indirect light and blurred reflections, of the size of the picture before; empty if it is being prepared.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} requested to stop
     */
    synchronized Optional<Film> traceLit(Before before, RenderedScenes after, Progress progress) {
        Scene first = before.scenes().scene();
        if (litBefore == null || litBefore.scene() != first) {
            litBefore = litPictures.of(first, progress).map(film -> new LitBefore(first, film)).orElse(null);
        }
        LitBefore known = litBefore;
        return known == null ? Optional.empty()
                : litPictures.of(after.scene(), progress).map(film -> EditEstimate.of(before.film(), known.film(), film,
                        !before.geometry().canServe(after.scene())));
    }

    /** Sets the pixels that all threads trace per second, as measured by another coarse picture; 0 if unknown. */
    synchronized void setSpeed(double measured) {
        pixelsPerSecond = measured;
    }

    /** Returns the pixels that all threads trace per second; 0 if unknown. */
    synchronized double speed() {
        return pixelsPerSecond;
    }

    /** Returns the renderer's picture. */
    Before before() {
        return new Before(renderer.film(), new RenderedScenes(renderer.cache().scene(), renderer.cache().mirrored().scene()),
                renderer.cache().geometry());
    }

    /** Returns a preview of edited scenes. It is small if the size or the camera changed, else it has the size of the picture before. */
    synchronized Film trace(Before before, RenderedScenes after, int threads, Progress progress) {
        double share = (double) threads / renderer.options().threads();
        boolean isSameView = isSameView(before.scenes().scene(), after.scene());
        CoarseBefore known = isSameView && lastBefore != null && lastBefore.shows(before.scenes()) ? lastBefore : null;
        int pixels = known != null ? known.pixels()
                : CoarseSteps.of(after.scene()).during(isSameView ? SECONDS / 2 : SECONDS, pixelsPerSecond * share);
        CoarsePicture traced = CoarsePicture.trace(after, pixels, renderer::geometryOf, threads, progress);
        pixelsPerSecond = traced.pixelsPerSecond() / share;
        if (!isSameView) {
            return traced.film();
        }
        if (known == null) {
            known = new CoarseBefore(before.scenes(), pixels,
                    CoarsePicture.trace(before.scenes(), pixels, before.geometry()::withMaterialsOf, threads, progress));
            lastBefore = known;
        }
        CoarsePicture coarse = known.picture();
        return EditEstimate.of(before.film(), coarse.film(), traced.film(), !coarse.geometry().canServe(traced.scene()));
    }

    /** Forgets the pictures of a document that is no longer shown. */
    synchronized void clear() {
        litBefore = null;
        lastBefore = null;
        litPictures.clear();
    }

    @Override
    public void close() {
        litPictures.close();
    }

    /** Returns whether pictures of two scenes have the same size and camera. */
    static boolean isSameView(Scene a, Scene b) {
        return a.picture().width() == b.picture().width() && a.picture().height() == b.picture().height() && a.camera().equals(b.camera());
    }
}
