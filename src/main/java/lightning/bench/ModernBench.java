package lightning.bench;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.bench.result.ModernSampling;
import lightning.format.pov.PovRayRunner;
import lightning.format.pov.PovScene;

/**
 * Benchmark of a modern scene with and without anti-aliasing: first pass, edits, cold-start processes, and time against error, the last two
 * also of POV-Ray if installed.
 */
record ModernBench(BenchSettings settings, ResultCollector ledger, NamedScene scene, double bytesPerMs, ModernCollector collector) {
    private static final PictureSize COLD_SIZE = new PictureSize(640, 360);
    private static final PictureSize QUICK_SIZE = new PictureSize(96, 54);
    private static final int PROCESSES = 3;
    /** Time after which no further pair of processes is started: slow images are rendered once or twice. */
    private static final double COLD_MS = 20_000;
    /** Predicted time of anti-aliasing relative to a trace without, and of a cold process or POV-Ray relative to a warm full trace. */
    private static final double ANTIALIASING_FACTOR = 10;
    private static final double COLD_FACTOR = 3;
    private static final double START_MS = 1000;

    ModernBench(BenchSettings settings, ResultCollector ledger, NamedScene scene, double bytesPerMs) {
        this(settings, ledger, scene, bytesPerMs, ledger.addModern(scene.name(), PovScene.of(scene.scene(), "scene").losses()));
    }

    /** Returns the parts to measure. */
    List<BenchPart> parts(TraceThroughput throughput) {
        List<BenchPart> parts = new ArrayList<>();
        for (ModernSampling sampling : ModernSampling.values()) {
            String title = scene.name() + ", anti-aliasing " + sampling.label();
            double coldMs = throughput.fullMs(coldSize()) * (sampling == ModernSampling.NONE ? 1 : ANTIALIASING_FACTOR) * COLD_FACTOR;
            ModernEditBench edits = new ModernEditBench(settings, ledger, bytesPerMs);
            parts.add(
                    new BenchPart(title + ", edits", edits.predictedMs(), progress -> edits.measure(collector, scene, sampling, progress)));
            if (settings.processes() > 0 && scene.file() != null) {
                parts.add(BenchPart.ofProgram(title + ", from cold", PROCESSES * (2 * START_MS + Math.min(2 * coldMs, COLD_MS)), ledger,
                        progress -> measureCold(sampling, progress)));
            }
        }
        ErrorBench errors = new ErrorBench(settings);
        parts.add(new BenchPart(scene.name() + ", time against error", errors.predictedMs(throughput),
                progress -> collector.addCurve(errors.ours(scene.scene(), progress))));
        PovRayRunner.find().ifPresent(povRay -> parts.add(BenchPart.ofProgram(
                scene.name() + ", time against error of " + PovRayBench.PROGRAM, errors.predictedMs(throughput), ledger,
                progress -> collector.addCurve(errors.povRay(povRay, scene.scene(), progress)))));
        return parts;
    }

    private PictureSize coldSize() {
        return settings.quick() ? QUICK_SIZE : COLD_SIZE;
    }

    private void measureCold(ModernSampling sampling, Progress progress) throws IOException, InterruptedException {
        var meter = new ColdStartMeter(settings.threads(), Math.min(settings.processes(), PROCESSES), COLD_MS);
        NamedScene sampled = scene.withSampling(sampling.settings());
        collector.setCold(sampling, coldSize(), meter.measure(requireNonNull(scene.file()), sampled.scene(), coldSize(),
                sampled.renderOptions(), sampling.povRay(), progress));
    }
}
