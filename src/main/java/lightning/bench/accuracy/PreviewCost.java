package lightning.bench.accuracy;

import java.util.Arrays;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.engine.choice.Engines;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.scene.Camera;
import lightning.scene.Scene;
import lightning.scene.effects.PreviewScene;
import lightning.scene.effects.ViewEffects;
import lightning.scene.light.Light;

/**
 * Cost of the editor's preview at 600×600 pixels, with its reflections and with the shadows of the moved light.
 *
 * @param lightMs  median milliseconds of a redraw after a light moved, for the slowest light
 * @param cameraMs median milliseconds of a full-resolution draw, as after a camera move
 */
public record PreviewCost(double lightMs, double cameraMs) {
    private static final int SIZE = 600;
    private static final int WARM_UPS = 20;
    private static final int REPETITIONS = 15;

    /**
     * Measures a scene's preview.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} requests a stop
     */
    public static PreviewCost of(Scene scene, int threads, Progress progress) {
        Scene square = scene.withPicture(scene.picture().withSize(SIZE, SIZE));
        try (var preview = new Preview(threads, progress)) {
            String first = square.lights().isEmpty() ? "" : square.lights().getFirst().name();
            double camera = median(i -> preview.render(square.withCamera(moved(square.camera(), i)), first));
            double slowest = 0;
            for (Light light : square.lights()) {
                preview.render(square, light.name());
                slowest = Math.max(slowest, median(i -> preview.render(square.withLight(moved(light, i)), light.name())));
            }
            return new PreviewCost(slowest, camera);
        }
    }

    /** Renderer with the options of the editor's preview, as they are without a change by the user. */
    static final class Preview implements AutoCloseable {
        private final PreviewScene scenes = new PreviewScene();
        private final RenderOptions options;
        private final Progress progress;
        private final Renderer renderer;

        Preview(int threads, Progress progress) {
            options = RenderOptions.DEFAULT.withThreads(threads).withEngines(Engines.FASTEST);
            this.progress = progress;
            renderer = new Renderer(options);
        }

        /** Returns the milliseconds of a draw with the shadows of one light, as of the selected one. */
        double render(Scene scene, String shadowLight) {
            return draw(scene, shadowLight).milliseconds();
        }

        UpdateResult draw(Scene scene, String shadowLight) {
            PreviewScene.Request request = scenes.request(scene, shadowLight, ViewEffects.PREVIEW, true);
            renderer.setOptions(options.withView(request.effects()));
            return renderer.render(request.scene(), progress);
        }

        @Override
        public void close() {
            renderer.close();
        }
    }

    private static double median(java.util.function.IntToDoubleFunction render) {
        double[] times = new double[REPETITIONS];
        for (int i = -WARM_UPS; i < REPETITIONS; i++) {
            times[Math.max(i, 0)] = render.applyAsDouble(i);
        }
        Arrays.sort(times);
        return times[REPETITIONS / 2];
    }

    private static Camera moved(Camera camera, int i) {
        Vec3 offset = camera.to().minus(camera.from()).times(1e-3 * i);
        return new Camera(camera.from().plus(offset), camera.to(), camera.up(), camera.fov(), camera.shift());
    }

    private static Light moved(Light light, int i) {
        Vec3 offset = new Vec3(1e-3 * i, 0, 0);
        return light.withPosition(light.position().plus(offset)).withDirection(light.direction().plus(offset));
    }
}
