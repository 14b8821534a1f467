package lightning.editor.loop;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.relight.PictureTooLargeException;
import lightning.render.relight.Renderer;
import lightning.render.relight.tile.RenderOptions;
import lightning.render.trace.Geometry;
import lightning.scene.AntialiasMode;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;

/**
 * Low-resolution preview image of a whole scene.
 *
 * @param scene    scene of the image
 * @param geometry primitives and BVH of the scene, reusable by a first pass
 * @param film     image, smaller than the scene's
 */
public record CoarsePicture(Scene scene, Geometry geometry, Film film) {
    /** Approximate pixel counts of the coarse images. The first is fast enough for a process whose code is not compiled yet. */
    private static final List<Integer> PIXEL_COUNTS = List.of(2_000, 30_000);
    /** Minimum ratio of samples in the final image to pixels in a coarse one. Below it, the final image is ready too soon for a preview. */
    private static final int MIN_SAMPLES_PER_PIXEL = 16;

    /**
     * Renders the first preview before anything else renders the scene. Pass it to {@link RenderLoop#setStartupPreview}.
     *
     * @return empty if the final image is ready as soon, or is too large to render
     */
    public static Optional<CoarsePicture> first(Scene scene, RenderOptions options) {
        try (var renderer = new Renderer(options)) {
            renderer.requireMemory(scene, 0);
            return sizes(scene.picture()).stream().findFirst()
                    .map(pixels -> trace(scene, pixels, renderer::prepare, options.threads(), Progress.NONE));
        } catch (PictureTooLargeException e) {
            return Optional.empty();
        }
    }

    /** Returns the pixel counts of the useful coarse images, smallest first. */
    static List<Integer> sizes(PictureSettings picture) {
        SamplingSettings sampling = picture.sampling();
        double samples = pixels(picture) * (sampling.antialias() == AntialiasMode.EVERY ? sampling.samplesPerPixel() : 1);
        return PIXEL_COUNTS.stream().filter(pixels -> samples / pixels >= MIN_SAMPLES_PER_PIXEL).toList();
    }

    /** @param geometryOf supplies the geometry of a scene */
    static CoarsePicture trace(Scene scene, int pixels, Function<Scene, Geometry> geometryOf, int threads, Progress progress) {
        PictureSettings picture = scene.picture();
        double shrink = Math.max(1, Math.sqrt(pixels(picture) / pixels));
        Scene small = scene.withPicture(picture.withSize(side(picture.width() / shrink), side(picture.height() / shrink))
                .withSampling(SamplingSettings.DEFAULT));
        Geometry geometry = geometryOf.apply(small);
        try (var workers = new WorkerPool(threads)) {
            return new CoarsePicture(scene, geometry, new TraditionalTracer(small, geometry).trace(workers, progress).film());
        }
    }

    private static double pixels(PictureSettings picture) {
        return (double) picture.width() * picture.height();
    }

    private static int side(double pixels) {
        return (int) Math.max(1, pixels);
    }
}
