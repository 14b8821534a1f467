package lightning.render.measure;

import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.scene.Camera;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.value.LensShift;
import lightning.scene.value.SceneLimits;

/**
 * Meter of the error of area lights: compares a scene's image with the mean of {@value #REFERENCES} images of the most samples, whose points differ by a
 * hundredth of a pixel or less, so that each uses other samples. Without anti-aliasing, indirect light and environment. Not thread-safe.
 */
public final class SoftShadowErrorMeter implements AutoCloseable {
    /** Number of reference images. */
    public static final int REFERENCES = 16;
    /** Shift of the image between two references, relative to its width. */
    private static final double SHIFT = 1e-6;

    private final Scene scene;
    private final Renderer renderer;
    private final double[] reference;

    /**
     * Result of one number of samples.
     *
     * @param time milliseconds of the first pass
     * @param mean mean error ({@link RelativeErrors})
     * @param high 95th percentile of the errors
     */
    public record Measured(Timing time, double mean, double high) {}

    /**
     * Renders the references.
     *
     * @param scene   scene at the size to measure
     * @param options render options; accuracy and view should be those of a final image
     * @throws java.util.concurrent.CancellationException if {@code progress} requests a stop
     */
    public SoftShadowErrorMeter(Scene scene, RenderOptions options, Progress progress) {
        this.scene = scene.withPicture(scene.picture().withSampling(SamplingSettings.DEFAULT)).withoutIndirect()
                .withWorld(scene.world().withoutEnvironments());
        renderer = new Renderer(options);
        reference = new double[scene.picture().width() * scene.picture().height()];
        Scene densest = new SweptSetting.LightSamples(SceneLimits.MAX_LIGHT_SAMPLES).applyTo(this.scene);
        for (int i = 0; i < REFERENCES; i++) {
            Camera camera = scene.camera();
            LensShift shift = camera.shift();
            renderer.clear();
            renderer.render(densest.withCamera(new Camera(camera.from(), camera.to(), camera.up(), camera.fov(),
                    new LensShift(shift.x() + i * SHIFT, shift.y()))), progress.cancellationOnly());
            double[] light = RelativeErrors.luminances(renderer.film());
            for (int p = 0; p < light.length; p++) {
                reference[p] += light[p] / REFERENCES;
            }
        }
    }

    /**
     * Measures the first pass and the error of a number of samples.
     *
     * @param repetitions number of samples of the time after one warm-up, ≥ 1
     * @throws java.util.concurrent.CancellationException if {@code progress} requests a stop
     */
    public Measured measure(int samples, int repetitions, Progress progress) {
        Scene measured = new SweptSetting.LightSamples(samples).applyTo(scene);
        Timing time = Timing.ofFirstPass(renderer, measured, repetitions, progress);
        RelativeErrors errors = RelativeErrors.of(RelativeErrors.luminances(renderer.film()), reference);
        return new Measured(time, errors.mean(), errors.percentile(IndirectError.HIGH));
    }

    @Override
    public void close() {
        renderer.close();
    }
}
