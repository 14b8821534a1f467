package lightning.bench.accuracy;

import java.util.Arrays;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.render.engine.choice.Engines;
import lightning.render.relight.Renderer;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.Camera;
import lightning.scene.Light;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;

/**
 * Cost of the editor's preview at 600×600 pixels.
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
        try (Renderer preview =
                new Renderer(RenderOptions.DEFAULT.withThreads(threads).withView(ViewEffects.PREVIEW).withEngines(Engines.FASTEST))) {
            double camera = median(i -> preview.render(square.withCamera(moved(square.camera(), i)), progress).milliseconds());
            preview.render(square, progress);
            double slowest = 0;
            for (Light light : square.lights()) {
                slowest = Math.max(slowest, median(i -> preview.render(square.withLight(moved(light, i)), progress).milliseconds()));
            }
            return new PreviewCost(slowest, camera);
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
        return new Camera(camera.from().plus(offset), camera.to(), camera.up(), camera.fov());
    }

    private static Light moved(Light light, int i) {
        Vec3 offset = new Vec3(1e-3 * i, 0, 0);
        return light.withPosition(light.position().plus(offset)).withDirection(light.direction().plus(offset));
    }
}
