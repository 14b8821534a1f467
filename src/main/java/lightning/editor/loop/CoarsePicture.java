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
 * A look at all of a picture, in few pixels.
 *
 * @param scene    whose picture it is
 * @param geometry what its rays can meet, of which a first pass can begin
 * @param film     smaller than the picture
 */
public record CoarsePicture(Scene scene, Geometry geometry, Film film) {
    /** So many pixels coarse pictures have, about: the first is there at once in a process that has compiled nothing yet. */
    private static final List<Integer> PIXEL_COUNTS = List.of(2_000, 30_000);
    /** A picture of fewer samples for each pixel of a coarse one is there before that could be looked at. */
    private static final int MIN_SAMPLES_PER_PIXEL = 16;

    /**
     * The first look, before anything renders the scene; it can be handed to what does ({@link RenderLoop#setStartupPreview}).
     *
     * @return empty where the picture itself is there as soon, or too large to be made
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

    /** How many pixels the coarse pictures have that are worth a look, the least first. */
    static List<Integer> sizes(PictureSettings picture) {
        SamplingSettings sampling = picture.sampling();
        double samples = pixels(picture) * (sampling.antialias() == AntialiasMode.EVERY ? sampling.samplesPerPixel() : 1);
        return PIXEL_COUNTS.stream().filter(pixels -> samples / pixels >= MIN_SAMPLES_PER_PIXEL).toList();
    }

    /** @param geometryOf what the rays of a scene can meet */
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
