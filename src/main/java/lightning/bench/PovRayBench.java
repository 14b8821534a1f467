package lightning.bench;

import java.io.IOException;
import java.util.Optional;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.bench.accuracy.RivalTiming;
import lightning.bench.accuracy.UpdateSavingMeter;
import lightning.bench.result.PeerResult;
import lightning.bench.result.TimeSamples;
import lightning.format.pov.PovRayRunner;
import lightning.format.pov.PovScene;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;

/** Benchmark of POV-Ray against our full trace, with a comparison of their visible shapes. */
record PovRayBench(PovRayRunner povRay) {
    static final String PROGRAM = "POV-Ray 3.7";
    private static final String MEASURE = "pixels that show the same shape (or background), each shape in a flat color of its own";
    private static final int REPETITIONS = 3;
    /** Number of traces for warm-up, program start, and the flat-color image. */
    private static final int EXTRA_TRACES = 6;
    /** Approximate slowdown relative to our full trace of the same scene. */
    private static final double SLOWDOWN = 10;
    private static final double START_MS = 300;

    /** Returns the installed POV-Ray, if any. */
    static Optional<PovRayBench> find() {
        return PovRayRunner.find().map(PovRayBench::new);
    }

    /** Returns the measurement; a failure of POV-Ray becomes a failed measurement. */
    BenchPart part(BenchSettings settings, ResultCollector ledger, ResultCollector.SceneCollector collector, NamedScene scene,
            PictureSize size, TraceThroughput throughput) {
        int traces = REPETITIONS + EXTRA_TRACES;
        String title = scene.name() + " at " + size + ", " + PROGRAM;
        return BenchPart.ofProgram(title, traces * (SLOWDOWN * throughput.fullMs(size) + START_MS), ledger,
                progress -> collector.setPeer(measure(size.of(scene.scene()), settings.threads(), progress.cancellationOnly())));
    }

    private PeerResult measure(Scene scene, int threads, Progress progress) throws IOException, InterruptedException {
        PovScene exported = PovScene.of(scene, "scene");
        int width = scene.picture().width();
        int height = scene.picture().height();
        try (UpdateSavingMeter meter = new UpdateSavingMeter(RenderOptions.DEFAULT.withThreads(threads), REPETITIONS, 0, 1)) {
            RivalTiming times = meter.compareWith(scene, () -> povRay.traceMs(exported, width, height, threads), progress);
            return new PeerResult(PROGRAM, TimeSamples.of(times.rival()), TimeSamples.of(times.full()), times.ratio(),
                    agreement(FlatColorScene.of(scene), threads, progress), MEASURE, exported.losses());
        } catch (IOException | InterruptedException | RuntimeException e) {
            throw e;
        } catch (Exception e) {
            throw new IllegalStateException("unexpected exception of a trace", e);
        }
    }

    private double agreement(Scene flat, int threads, Progress progress) throws IOException, InterruptedException {
        Film rival = povRay.render(PovScene.of(flat, "flat"), flat.picture().width(), flat.picture().height(), threads);
        try (WorkerPool workers = new WorkerPool(threads)) {
            return agreement(new TraditionalTracer(flat).trace(workers, progress).film(), rival);
        }
    }

    /** Returns the share of pixels, 0…1, whose display codes differ less than any two flat colors. */
    static double agreement(Film ours, Film rival) {
        int[] a = ViewTransform.DEFAULT.toPixels(ours);
        int[] b = ViewTransform.DEFAULT.toPixels(rival);
        int equalPixels = 0;
        for (int i = 0; i < a.length; i++) {
            equalPixels += isNear(a[i], b[i]) && isNear(a[i] >> 8, b[i] >> 8) && isNear(a[i] >> 16, b[i] >> 16) ? 1 : 0;
        }
        return (double) equalPixels / a.length;
    }

    private static boolean isNear(int a, int b) {
        return 2 * Math.abs((a & 0xFF) - (b & 0xFF)) < FlatColorScene.STEP;
    }
}
