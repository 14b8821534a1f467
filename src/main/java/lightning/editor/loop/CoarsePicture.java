package lightning.editor.loop;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.relight.PictureTooLarge;
import lightning.render.relight.Renderer;
import lightning.render.relight.tile.Options;
import lightning.render.trace.Geometry;
import lightning.scene.Antialias;
import lightning.scene.Picture;
import lightning.scene.Sampling;
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
    private static final List<Integer> PIXELS = List.of(2_000, 30_000);
    /** A picture of fewer samples for each pixel of a coarse one is there before that could be looked at. */
    private static final int LEAST_SHARE = 16;

    /**
     * The first look, before anything renders the scene; it can be handed to what does ({@link RenderLoop#begin}).
     *
     * @return empty where the picture itself is there as soon, or too large to be made
     */
    public static Optional<CoarsePicture> first(Scene scene, Options options) {
        try (var renderer = new Renderer(options)) {
            renderer.check(scene, 0);
            return sizes(scene.picture()).stream().findFirst()
                    .map(pixels -> of(scene, pixels, renderer::prepare, options.threads(), Progress.NONE));
        } catch (PictureTooLarge e) {
            return Optional.empty();
        }
    }

    /** How many pixels the coarse pictures have that are worth a look, the least first. */
    static List<Integer> sizes(Picture picture) {
        Sampling sampling = picture.sampling();
        double samples = pixels(picture) * (sampling.antialias() == Antialias.EVERY ? sampling.perPixel() : 1);
        return PIXELS.stream().filter(pixels -> samples / pixels >= LEAST_SHARE).toList();
    }

    /** @param prepared what the rays of a scene can meet */
    static CoarsePicture of(Scene scene, int pixels, Function<Scene, Geometry> prepared, int threads, Progress progress) {
        Picture picture = scene.picture();
        double shrink = Math.max(1, Math.sqrt(pixels(picture) / pixels));
        Scene small = scene.withPicture(picture.withSize(side(picture.width() / shrink), side(picture.height() / shrink))
                .withSampling(Sampling.DEFAULT));
        Geometry geometry = prepared.apply(small);
        try (var workers = new Workers(threads)) {
            return new CoarsePicture(scene, geometry, new TraditionalTracer(small, geometry).trace(workers, progress).film());
        }
    }

    private static double pixels(Picture picture) {
        return (double) picture.width() * picture.height();
    }

    private static int side(double pixels) {
        return (int) Math.max(1, pixels);
    }
}
