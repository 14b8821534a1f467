package lightning.render.measure;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.cache.TileLevel;
import lightning.render.engine.choice.Engines;
import lightning.render.gather.GatherStructure;
import lightning.render.relight.Renderer;
import lightning.render.trace.PixelRays;
import lightning.scene.IndirectSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;

/**
 * Meter of the error of indirect light: renders a scene with any settings and compares random pixels with brute force by the same tracer
 * ({@value #RAYS} rays from each pixel and {@value #HIT_RAYS} from each hit). Not thread-safe.
 *
 * <p>{@link #traceReference} must come before {@link #measure}.
 */
public final class IndirectErrorMeter implements AutoCloseable {
    /** Rays of the reference from each pixel, and from each hit. */
    public static final int RAYS = BruteForceGather.RAYS;
    public static final int HIT_RAYS = BruteForceGather.HIT_RAYS;
    private static final long SEED = 5;

    private final Scene scene;
    private final Renderer renderer;
    private final WorkerPool workers;
    private List<Sample> samples = List.of();

    /**
     * Sampled pixel that shows a surface.
     *
     * @param references luminance by brute force for one bounce, two, …
     */
    private record Sample(int pixel, double[] references) {}

    /**
     * @param scene   scene at the size to measure; anti-aliasing is switched off
     * @param options render options; accuracy and view should be those of a final image
     */
    public IndirectErrorMeter(Scene scene, RenderOptions options) {
        this.scene = scene.withPicture(scene.picture().withSampling(SamplingSettings.DEFAULT));
        renderer = new Renderer(options.withEngines(Engines.FASTEST));
        workers = new WorkerPool(options.threads());
    }

    /**
     * Result of one setting.
     *
     * @param error  errors of all sampled pixels
     * @param time   milliseconds of the first pass
     * @param points number of gather points
     * @param surfels number of surfels
     */
    public record Measured(IndirectError error, Timing time, int points, int surfels) {}

    /**
     * Traces the reference at random pixels, always in the same order, until either limit is reached.
     *
     * @param maxPixels maximum number of pixels
     * @param maxMs     time after which no further pixels are traced, milliseconds
     * @return number of pixels that show a surface
     * @throws CancellationException if {@code progress} requests a stop
     */
    public int traceReference(int maxPixels, double maxMs, Progress progress) {
        renderer.clear();
        renderer.render(withIndirect(Optional.empty()), progress.cancellationOnly());
        PixelCache cache = renderer.cache();
        List<BruteForceGather> gathers = new ArrayList<>();
        for (int i = 0; i < workers.count(); i++) {
            gathers.add(new BruteForceGather(scene, cache.geometry()));
        }
        PixelRays rays = new PixelRays(scene);
        int width = scene.picture().width();
        samples = SampledPixels.compute(scene.picture(), SEED, workers, maxPixels, maxMs, progress,
                (worker, pixel) -> Optional.ofNullable(gathers.get(worker).luminances(rays.ray(pixel % width, pixel / width), pixel))
                        .map(light -> new Sample(pixel, light)));
        return samples.size();
    }

    /**
     * Measures the first pass without indirect light.
     *
     * @param repetitions number of samples after one warm-up, ≥ 1
     * @throws CancellationException if {@code progress} requests a stop
     */
    public Timing measureWithout(int repetitions, Progress progress) {
        return Timing.ofFirstPass(renderer, withIndirect(Optional.empty()), repetitions, progress);
    }

    /**
     * Measures the first pass and the error of settings.
     *
     * @param repetitions number of samples of the time after one warm-up, ≥ 1
     * @throws CancellationException    if {@code progress} requests a stop
     * @throws IllegalArgumentException if no sampled pixel shows a surface
     */
    public Measured measure(IndirectSettings settings, int repetitions, Progress progress) {
        Timing time = Timing.ofFirstPass(renderer, withIndirect(Optional.of(settings)), repetitions, progress);
        PixelCache cache = renderer.cache();
        double[] light = new double[samples.size()];
        double[] exact = new double[light.length];
        double[] complete = new double[light.length];
        float[][] points = requireNonNull(cache.indirect()).light().sum(cache.parts());
        for (int i = 0; i < light.length; i++) {
            light[i] = luminance(cache, points, samples.get(i).pixel);
            exact[i] = samples.get(i).references[settings.bounces() - 1];
            complete[i] = samples.get(i).references[BruteForceGather.BOUNCES - 1];
        }
        GatherStructure paths = requireNonNull(cache.indirect()).structure();
        return new Measured(IndirectError.of(light, exact, complete), time, paths.pointCount(), paths.surfelCount());
    }

    private Scene withIndirect(Optional<IndirectSettings> settings) {
        return scene.withPicture(scene.picture().withIndirect(settings));
    }

    /** @param points light at all points */
    private static double luminance(PixelCache cache, float[][] points, int pixel) {
        TileLevel level = SampledPixels.level(cache, pixel);
        float[] light = new float[points.length];
        requireNonNull(level.weights()).interpolate(points, SampledPixels.row(cache, level.rows(), pixel), light);
        return BruteForceGather.luminance(light[0], light[1], light[2]);
    }

    @Override
    public void close() {
        renderer.close();
        workers.close();
    }
}
