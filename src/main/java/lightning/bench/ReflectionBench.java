package lightning.bench;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.bench.result.ReflectionAccuracy;
import lightning.bench.result.TimeSamples;
import lightning.render.RenderOptions;
import lightning.render.measure.ReflectionErrorMeter;
import lightning.render.measure.SweptEffect;
import lightning.scene.PictureSettings;

/** Benchmark of blurred reflections: time against error on scenes that have some. */
record ReflectionBench(BenchSettings settings, ResultCollector ledger) {
    private static final PictureSize SIZE = new PictureSize(960, 540);
    private static final PictureSize QUICK_SIZE = new PictureSize(48, 27);
    private static final int PIXELS = 4000;
    private static final int QUICK_PIXELS = 100;
    private static final double REFERENCE_MS = 30_000;
    /** Predicted milliseconds of a scene. */
    private static final double MS = 90_000;
    private static final double QUICK_MS = 2000;

    /** Returns the parts to measure for these scenes. */
    List<BenchPart> parts(List<NamedScene> scenes) {
        return scenes.stream().filter(scene -> SweptEffect.BLURRED_REFLECTIONS.missingReason(scene.scene()).isEmpty())
                .map(scene -> new BenchPart(scene.name() + ", time against error of blurred reflections", settings.quick() ? QUICK_MS : MS,
                        progress -> measure(scene, progress)))
                .toList();
    }

    private void measure(NamedScene named, Progress progress) {
        PictureSize size = settings.quick() ? QUICK_SIZE : SIZE;
        Progress silent = progress.cancellationOnly();
        try (var meter = new ReflectionErrorMeter(size.of(named.scene()), RenderOptions.DEFAULT.withThreads(settings.threads()))) {
            int pixels = meter.traceReference(settings.quick() ? QUICK_PIXELS : PIXELS, REFERENCE_MS, silent);
            List<ReflectionAccuracy.Point> points = new ArrayList<>();
            // A scene may show only coated and frosted surfaces, which are not measured.
            for (int rays : pixels == 0 ? List.<Integer>of() : PictureSettings.REFLECTION_RAY_COUNTS) {
                ReflectionErrorMeter.Measured result = meter.measure(rays, settings.repetitions(), silent);
                points.add(new ReflectionAccuracy.Point(rays, result.points(), TimeSamples.of(result.time()), result.mean(), result.shown(),
                        result.high(),
                        result.bias()));
                progress.report(points.size(), PictureSettings.REFLECTION_RAY_COUNTS.size());
            }
            ledger.indirect().add(new ReflectionAccuracy(named.name(), size.width(), size.height(), pixels, points));
        }
    }
}
