package lightning.document.loop;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.relight.MemoryEstimate;
import lightning.render.relight.PictureTooLargeException;
import lightning.render.relight.Renderer;
import lightning.render.shading.RenderedScenes;
import lightning.render.trace.Geometry;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.effects.PreviewScene;
import lightning.scene.light.Light;
import lightning.scene.value.SceneLimits;

/**
 * Low-resolution preview image of a whole scene, without the effects that take most of the time: indirect light and blurred
 * reflections. Area lights have few samples.
 *
 * @param scene           scene of the image
 * @param geometry        its primitives and BVH, reusable by a first pass
 * @param film            image, smaller than the scene's
 * @param pixelsPerSecond pixels that were traced per second
 */
public record CoarsePicture(Scene scene, Geometry geometry, Film film, double pixelsPerSecond) {
    /**
     * Renders the first previews before anything else renders the scene. Pass the result to {@link RenderLoop#setStartupPreview}.
     *
     * @param listener receives each preview
     * @return the last one; empty if the final image is ready as soon, or is too large to render
     */
    public static Optional<CoarsePicture> first(Scene scene, RenderOptions options, Consumer<Film> listener) {
        CoarseSteps steps = CoarseSteps.of(scene);
        if (steps.first() == 0 || !isFilmPossible(scene, options)) {
            return Optional.empty();
        }
        try (var renderer = new Renderer(options)) {
            var pass = new CoarsePass(RenderedScenes.of(scene), renderer::prepare, options, listener, Progress.NONE);
            pass.showFirst(0);
            return pass.last();
        }
    }

    /**
     * Traces a preview in about a given time.
     *
     * @param pixelsPerSecond speed of the last one; 0 if there is none
     * @param renderer        supplies geometry; keeps its cache
     */
    public static CoarsePicture during(double seconds, double pixelsPerSecond, Scene scene, Renderer renderer, Progress progress) {
        int pixels = CoarseSteps.of(scene).during(seconds, pixelsPerSecond);
        return trace(RenderedScenes.of(scene), pixels, renderer::geometryOf, renderer.options().threads(), progress);
    }

    /** Returns whether memory has room for the film of a scene, which its display needs in any case. */
    static boolean isFilmPossible(Scene scene, RenderOptions options) {
        try {
            MemoryEstimate.checkFilm(scene.picture(), options.memory());
            return true;
        } catch (PictureTooLargeException e) {
            return false;
        }
    }

    /**
     * @param scenes     scene of the image and scene of its reflections
     * @param pixels     approximate number of pixels
     * @param geometryOf supplies the geometry of a scene
     */
    static CoarsePicture trace(RenderedScenes scenes, int pixels, Function<Scene, Geometry> geometryOf, int threads, Progress progress) {
        PictureSettings picture = scenes.scene().picture();
        double shrink = Math.max(1, Math.sqrt((double) picture.width() * picture.height() / pixels));
        return trace(scenes, side(picture.width() / shrink), side(picture.height() / shrink), geometryOf, threads, progress);
    }

    /** @param width size of the image in pixels, with {@code height} */
    static CoarsePicture trace(RenderedScenes scenes, int width, int height, Function<Scene, Geometry> geometryOf, int threads,
            Progress progress) {
        Scene small = shrink(withoutSlowEffects(scenes.scene()), width, height);
        Scene mirrored = scenes.mirrored() == scenes.scene() ? small : shrink(withoutSlowEffects(scenes.mirrored()), width, height);
        Geometry geometry = geometryOf.apply(small);
        long start = System.nanoTime();
        try (var workers = new WorkerPool(threads)) {
            TraditionalTracer.Result result = new TraditionalTracer(small, mirrored, geometry).trace(workers, progress.cancellationOnly());
            progress.raysCast(result.rays().total());
            return new CoarsePicture(scenes.scene(), geometry, result.film(), pixels(result.film()) / seconds(start));
        }
    }

    private static Scene withoutSlowEffects(Scene scene) {
        return PreviewScene.withoutBlur(scene.withoutIndirect());
    }

    private static Scene shrink(Scene scene, int width, int height) {
        Scene small = scene.withPicture(scene.picture().withSize(width, height).withSampling(SamplingSettings.DEFAULT));
        for (Light light : scene.lights()) {
            if (light.area().samples() > SceneLimits.MIN_LIGHT_SAMPLES) {
                small = small.withLight(light.withArea(light.area().with(area -> area.samples(SceneLimits.MIN_LIGHT_SAMPLES))));
            }
        }
        return small;
    }

    /** Returns whether this is a coarse image of a scene, whose size and samples may be others. */
    boolean shows(Scene other) {
        PictureSettings picture = other.picture();
        return scene == other || scene.withPicture(scene.picture().withSize(picture.width(), picture.height())
                .withSampling(picture.sampling())).equals(other);
    }

    /** Returns the number of pixels. */
    int pixels() {
        return pixels(film);
    }

    static int pixels(Film film) {
        return film.width() * film.height();
    }

    private static double seconds(long startNs) {
        return Math.max(1, System.nanoTime() - startNs) / 1e9;
    }

    private static int side(double pixels) {
        return (int) Math.max(1, pixels);
    }
}
