package lightning.bench;

import static java.util.Objects.requireNonNull;

import lightning.format.pov.PovRayRunner;
import lightning.format.pov.PovSampling;

/** Benchmark of cold-start processes that render an image: ours, in turns with POV-Ray if installed. */
record ColdStartBench(BenchSettings settings, ResultCollector ledger) {
    /** Predicted start time of a process in milliseconds, and its trace time relative to a warm full trace. */
    private static final double START_MS = 1000;
    private static final double COLD_SLOWDOWN = 20;

    /** Returns the measurement; a failure of a program becomes a failed measurement. */
    BenchPart part(ResultCollector.SceneCollector collector, NamedScene scene, PictureSize size, TraceThroughput throughput) {
        String title = scene.name() + " at " + size + ", from cold";
        double processMs = START_MS + COLD_SLOWDOWN * throughput.fullMs(size);
        double predictedMs = (settings.processes() + 1) * processMs * (PovRayRunner.find().isPresent() ? 2 : 1);
        var meter = new ColdStartMeter(settings.threads(), settings.processes(), Double.POSITIVE_INFINITY);
        return BenchPart.ofProgram(title, predictedMs, ledger, progress -> collector.setColdStart(meter.measure(
                requireNonNull(scene.file()), scene.scene(), size, scene.renderOptions(), PovSampling.NONE, progress)));
    }
}
