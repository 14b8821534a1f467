package lightning.render.measure;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.math.Ray;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.cache.TileLevel;
import lightning.render.engine.choice.Engines;
import lightning.render.relight.Renderer;
import lightning.render.shading.Bsdf;
import lightning.render.shading.PrincipledWeights;
import lightning.render.trace.Geometry;
import lightning.render.trace.PixelRays;
import lightning.render.trace.SurfacePoint;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;

/**
 * Meter of the error of blurred reflections: renders a scene with any number of rays and compares what random pixels reflect with brute force
 * by the same tracer ({@value BruteForceReflection#RAYS} rays from each pixel). It measures opaque surfaces without a coat and a sheen, in scenes without
 * indirect light. Not thread-safe.
 *
 * <p>{@link #traceReference} must come before {@link #measure}.
 */
public final class ReflectionErrorMeter implements AutoCloseable {
    private static final long SEED = 7;

    private final Scene scene;
    private final Renderer renderer;
    private final WorkerPool workers;
    private List<Sample> samples = List.of();

    /**
     * Sampled pixel.
     *
     * @param factors factors of the mean light by which it becomes a luminance: three for what F0 multiplies, and three for what no color
     *                multiplies
     * @param reference luminance by brute force
     */
    private record Sample(int pixel, double[] factors, double reference) {}

    /**
     * Result of one number of rays.
     *
     * @param mean   mean error of what the pixels reflect ({@link RelativeErrors})
     * @param shown  mean error of their whole colors, which this causes
     * @param high   95th percentile of the errors
     * @param bias   difference of the sums of all pixels, relative to the reference; negative if too dark
     * @param time   milliseconds of the first pass
     * @param points number of reflection points
     */
    public record Measured(double mean, double shown, double high, double bias, Timing time, int points) {}

    /**
     * @param scene   scene at the size to measure; anti-aliasing and indirect light are switched off
     * @param options render options; accuracy and view should be those of a final image
     */
    public ReflectionErrorMeter(Scene scene, RenderOptions options) {
        this.scene = scene.withPicture(scene.picture().withSampling(SamplingSettings.DEFAULT).withIndirect(Optional.empty()));
        renderer = new Renderer(options.withEngines(Engines.FASTEST));
        workers = new WorkerPool(options.threads());
    }

    /**
     * Traces the reference at random pixels, always in the same order, until either limit is reached.
     *
     * @param maxPixels maximum number of pixels that are tried
     * @param maxMs     time after which no further pixels are traced, milliseconds
     * @return number of pixels that show a measured surface
     * @throws CancellationException if {@code progress} requests a stop
     */
    public int traceReference(int maxPixels, double maxMs, Progress progress) {
        renderer.render(scene, progress.cancellationOnly());
        Geometry geometry = renderer.cache().geometry();
        List<BruteForceReflection> tracers = new ArrayList<>();
        for (int i = 0; i < workers.count(); i++) {
            tracers.add(new BruteForceReflection(scene, geometry));
        }
        PixelRays rays = new PixelRays(scene);
        int width = scene.picture().width();
        samples = SampledPixels.compute(scene.picture(), SEED, workers, maxPixels, maxMs, progress, (worker, pixel) -> {
            Ray ray = rays.ray(pixel % width, pixel / width);
            return Optional.ofNullable(tracers.get(worker).means(ray, pixel)).map(means -> {
                double[] factors = factors(geometry, ray);
                return new Sample(pixel, factors, luminance(factors, means));
            });
        });
        return samples.size();
    }

    private static double[] factors(Geometry geometry, Ray ray) {
        SurfacePoint at = geometry.surface(geometry.nearest(ray), ray);
        var material = (Bsdf.Principled) Bsdf.of(geometry.materials().material(at.material()));
        var weights = new PrincipledWeights();
        weights.moveTo(material, at);
        double[] factors = new double[6];
        for (int c = 0; c < 3; c++) {
            double luminance = BruteForceGather.luminance(c == 0 ? 1 : 0, c == 1 ? 1 : 0, c == 2 ? 1 : 0);
            factors[c] = luminance * at.specular()[c] * weights.reflected(material);
            factors[3 + c] = luminance * weights.reflectedGrazing(material);
        }
        return factors;
    }

    private static double luminance(double[] factors, double[] means) {
        double sum = 0;
        for (int i = 0; i < factors.length; i++) {
            sum += factors[i] * means[i];
        }
        return sum;
    }

    /**
     * Measures the first pass and the error of a number of rays.
     *
     * @param rays        rays of a point
     * @param repetitions number of samples of the time after one warm-up, ≥ 1
     * @throws CancellationException    if {@code progress} requests a stop
     * @throws IllegalArgumentException if no sampled pixel shows a measured surface
     */
    public Measured measure(int rays, int repetitions, Progress progress) {
        Timing time = Timing.ofFirstPass(renderer, scene.withPicture(scene.picture().withReflectionRays(rays)), repetitions, progress);
        PixelCache cache = renderer.cache();
        double[] light = samples.stream().mapToDouble(sample -> luminance(cache, sample)).toArray();
        double[] exact = samples.stream().mapToDouble(Sample::reference).toArray();
        RelativeErrors errors = RelativeErrors.of(light, exact);
        double[] shown = RelativeErrors.luminances(renderer.film());
        double[] pictured = samples.stream().mapToDouble(sample -> shown[sample.pixel]).toArray();
        double[] right = new double[light.length];
        double total = 0;
        double bias = 0;
        for (int i = 0; i < light.length; i++) {
            total += exact[i];
            bias += light[i] - exact[i];
            right[i] = pictured[i] - light[i] + exact[i];
        }
        return new Measured(errors.mean(), RelativeErrors.of(pictured, right).mean(), errors.percentile(IndirectError.HIGH),
                total > 0 ? bias / total : 0, time,
                requireNonNull(requireNonNull(cache.indirect()).structure().reflections()).count());
    }

    private static double luminance(PixelCache cache, Sample sample) {
        TileLevel level = SampledPixels.level(cache, sample.pixel);
        float[] light = new float[9];
        requireNonNull(level.weights()).interpolate(requireNonNull(cache.indirect()).light().sum(cache.parts()),
                SampledPixels.row(cache, level.rows(), sample.pixel), light);
        double[] means = new double[6];
        for (int i = 0; i < means.length; i++) {
            means[i] = light[3 + i];
        }
        return luminance(sample.factors, means);
    }

    @Override
    public void close() {
        renderer.close();
        workers.close();
    }
}
