package lightning.document.loop;

import static java.util.Objects.requireNonNull;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.image.Film;
import lightning.render.shading.RenderedScenes;
import lightning.render.trace.Geometry;
import lightning.scene.GatherSettings;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Coarse images of a scene, each with more pixels than the last, until its full image follows. Reports each one when it is finished. */
final class CoarsePass {
    /** Time for the first image, so that it follows a moving camera, in seconds. */
    private static final double MOVING_SECONDS = 0.05;
    /** Time for images after the first, before the full image is prepared, in seconds. */
    private static final double FIRST_SECONDS = 0.3;

    private final RenderedScenes scenes;
    private final Function<Scene, Geometry> geometryOf;
    private final RenderOptions options;
    private final Consumer<Film> listener;
    private final Progress progress;
    private final CoarseSteps steps;
    /** Last traced image; null before the first. */
    private @Nullable CoarsePicture last;
    /** Largest number of pixels shown. */
    private int shownPixels;
    /** Small picture with all light, and one of its size without the effects that coarse images lack; null before there are any. */
    private @Nullable Film lit;
    private @Nullable Film unlit;

    /**
     * @param geometryOf supplies the geometry of a scene
     * @param listener   receives each image
     */
    CoarsePass(RenderedScenes scenes, Function<Scene, Geometry> geometryOf, RenderOptions options, Consumer<Film> listener,
            Progress progress) {
        this.scenes = scenes;
        this.geometryOf = geometryOf;
        this.options = options;
        this.listener = listener;
        this.progress = progress;
        steps = CoarseSteps.of(scenes.scene());
    }

    /** Shows an image that was traced elsewhere. */
    void show(CoarsePicture picture) {
        last = picture;
        offer(lit == null ? picture.film() : EditEstimate.of(picture.film(), requireNonNull(unlit), lit, false));
    }

    /** Shows a small picture of the scene with all its light, which all further images have from it. */
    void offerLit(Film film) {
        offer(film);
        if (GatherSettings.of(scenes.scene()).isPresent()) {
            unlit = CoarsePicture.trace(scenes, film.width(), film.height(), geometryOf, options.threads(), progress).film();
            lit = film;
        }
    }

    /** Shows an image of the scene if it has more pixels than those shown. */
    private void offer(Film film) {
        int pixels = CoarsePicture.pixels(film);
        if (pixels > shownPixels) {
            shownPixels = pixels;
            listener.accept(film);
        }
    }

    private void trace(int pixels, Progress cancellation) {
        show(CoarsePicture.trace(scenes, pixels, geometryOf, options.threads(), cancellation));
    }

    /**
     * Traces images for a short time, one at least; none if the full image is ready as soon. The first is shown even if the work is canceled
     * meanwhile: while a camera moves, each picture is canceled by the next.
     *
     * @param perSecond pixels that were traced per second for an earlier scene, which decide the size of the first image; 0 if unknown
     */
    void showFirst(double perSecond) {
        if (last == null && steps.first() > 0) {
            trace(steps.during(MOVING_SECONDS, perSecond), Progress.NONE);
            showNext(FIRST_SECONDS);
        }
    }

    /** Traces further images that are ready within a time, in seconds. */
    void showNext(double seconds) {
        long start = System.nanoTime();
        for (int pixels = next(seconds); pixels > 0; pixels = next(seconds - (System.nanoTime() - start) / 1e9)) {
            trace(pixels, progress);
        }
    }

    private int next(double seconds) {
        return last == null ? 0 : steps.nextWithin(Math.max(shownPixels, last.pixels()), last.pixelsPerSecond(), seconds);
    }

    /** Traces all further images. */
    void showRest() {
        showNext(Double.POSITIVE_INFINITY);
    }

    /** Returns whether an image was shown. */
    boolean isShown() {
        return shownPixels > 0;
    }

    /** Returns the last traced image; empty if none was traced. */
    Optional<CoarsePicture> last() {
        return Optional.ofNullable(last);
    }

    /** Returns the pixels that were traced per second; 0 if none were. */
    double pixelsPerSecond() {
        return last == null ? 0 : last.pixelsPerSecond();
    }
}
