package lightning.bench;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.bench.accuracy.DisplayError;
import lightning.bench.result.ErrorCurve;
import lightning.bench.result.ErrorPoint;
import lightning.bench.result.ModernSampling;
import lightning.bench.result.TimeSamples;
import lightning.format.pov.PovRayRunner;
import lightning.format.pov.PovSampling;
import lightning.format.pov.PovScene;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.measure.Timing;
import lightning.scene.AntialiasMode;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.value.SceneLimits;

/**
 * Benchmark of time against error. Each program is compared with its own image of many samples, because the programs differ in more than
 * sampling: highlights, attenuation and area lights are not translated exactly.
 */
record ErrorBench(BenchSettings settings) {
    static final String PROGRAM = "Lightning";
    private static final PictureSize SIZE = new PictureSize(160, 90);
    private static final PictureSize QUICK_SIZE = new PictureSize(32, 18);
    /**
     * Images of many samples have this many times the width and height, and are averaged down: 10×10 samples per pixel. Our grids of 2×2,
     * 4×4 or 8×8 have no sample at the same place, which would hide errors.
     */
    private static final int REFERENCE_SCALE = 2;
    private static final int REFERENCE_GRID = 5;
    private static final int REPETITIONS = 3;
    /** Time after which a setting is not traced again. */
    private static final double REPEAT_MS = 1500;
    /** Predicted duration relative to a full trace without anti-aliasing. */
    private static final double PREDICTED_TRACES = 300;

    private static final List<PovSampling> POV_RAY = List.of(PovSampling.NONE, PovSampling.adaptive(0.3, 2), ModernSampling.EDGES.povRay(),
            PovSampling.adaptive(0.03, 4), PovSampling.grid(0, 2), PovSampling.grid(0, 4));

    /** Trace of one setting. */
    private record Trace(Film film, double ms) {}

    /** Traces an image once. */
    @FunctionalInterface
    private interface TraceTask {
        Trace trace() throws IOException, InterruptedException;
    }

    double predictedMs(TraceThroughput throughput) {
        return PREDICTED_TRACES * throughput.fullMs(size());
    }

    /** Returns our curve: full traces without a cache and without building the BVH. */
    ErrorCurve ours(Scene original, Progress progress) throws IOException, InterruptedException {
        Scene scene = size().of(original);
        Map<String, TraceTask> tasks = new LinkedHashMap<>();
        try (WorkerPool workers = new WorkerPool(settings.threads())) {
            for (SamplingSettings sampling : List.of(ModernSampling.NONE.settings(), new SamplingSettings(AntialiasMode.EDGES, 2),
                    ModernSampling.EDGES.settings(), new SamplingSettings(AntialiasMode.EDGES, 8),
                    new SamplingSettings(AntialiasMode.EVERY, 2), new SamplingSettings(AntialiasMode.EVERY, 4))) {
                tasks.put(label(sampling), () -> traced(withSampling(scene, sampling), workers, progress));
            }
            var many = new SamplingSettings(AntialiasMode.EVERY, REFERENCE_GRID);
            Film reference =
                    traced(withSampling(withManyLightSamples(referenceSize().of(original)), many), workers, progress).film();
            return curve(PROGRAM, points(tasks, averaged(reference), true, progress));
        }
    }

    /** Returns the scene with the largest number of samples for each area light: several hundred for each pixel of the reference. */
    private static Scene withManyLightSamples(Scene scene) {
        return scene.withLights(scene.lights().stream()
                .map(light -> light.hasSamples() ? light.withArea(light.area().withSamples(SceneLimits.MAX_LIGHT_SAMPLES)) : light)
                .toList());
    }

    /** Returns POV-Ray's curve: the trace times that it reports, without parsing. */
    ErrorCurve povRay(PovRayRunner povRay, Scene original, Progress progress) throws IOException, InterruptedException {
        PovScene scene = PovScene.of(size().of(original), "scene");
        Map<String, TraceTask> tasks = new LinkedHashMap<>();
        POV_RAY.forEach(sampling -> tasks.put(sampling.label(), () -> traced(povRay, scene, sampling)));
        Film reference = povRay.trace(scene, referenceSize().width(), referenceSize().height(), settings.threads(),
                PovSampling.grid(0, REFERENCE_GRID)).film();
        return curve(PovRayBench.PROGRAM, points(tasks, averaged(reference), false, progress));
    }

    private ErrorCurve curve(String program, List<ErrorPoint> points) {
        int samples = REFERENCE_SCALE * REFERENCE_SCALE * REFERENCE_GRID * REFERENCE_GRID;
        return new ErrorCurve(program, samples, size().width(), size().height(), points);
    }

    private Film averaged(Film reference) {
        return FilmDownscaler.average(reference, size().width());
    }

    private static List<ErrorPoint> points(Map<String, TraceTask> tasks, Film reference, boolean needsWarmUp, Progress progress)
            throws IOException, InterruptedException {
        List<ErrorPoint> points = new ArrayList<>();
        for (var task : tasks.entrySet()) {
            Film film = needsWarmUp ? task.getValue().trace().film() : null;
            List<Double> times = new ArrayList<>();
            double totalMs = 0;
            while (times.isEmpty() || times.size() < REPETITIONS && totalMs < REPEAT_MS) {
                progress.checkCanceled("canceled while measuring errors");
                Trace trace = task.getValue().trace();
                film = trace.film();
                times.add(trace.ms());
                totalMs += trace.ms();
            }
            points.add(new ErrorPoint(task.getKey(), TimeSamples.of(new Timing(times)), DisplayError.of(requireNonNull(film), reference)));
            progress.report(points.size(), tasks.size());
        }
        return points;
    }

    private static Trace traced(Scene scene, WorkerPool workers, Progress progress) {
        TraditionalTracer tracer = new TraditionalTracer(scene).withEngines(Engines.FASTEST);
        long start = System.nanoTime();
        Film film = tracer.trace(workers, progress.cancellationOnly()).film();
        return new Trace(film, (System.nanoTime() - start) / 1e6);
    }

    private Trace traced(PovRayRunner povRay, PovScene scene, PovSampling sampling) throws IOException, InterruptedException {
        PovRayRunner.Trace trace = povRay.trace(scene, size().width(), size().height(), settings.threads(), sampling);
        return new Trace(trace.film(), trace.ms());
    }

    private static Scene withSampling(Scene scene, SamplingSettings sampling) {
        return scene.withPicture(scene.picture().withSampling(sampling));
    }

    /** Returns a label as in {@code edges 4×4}. */
    private static String label(SamplingSettings sampling) {
        return sampling.isSupersampled()
                ? sampling.antialias().name().toLowerCase(Locale.ROOT) + " " + sampling.grid() + "×" + sampling.grid()
                : ModernSampling.NONE.label();
    }

    private PictureSize size() {
        return settings.quick() ? QUICK_SIZE : SIZE;
    }

    private PictureSize referenceSize() {
        return new PictureSize(REFERENCE_SCALE * size().width(), REFERENCE_SCALE * size().height());
    }
}
