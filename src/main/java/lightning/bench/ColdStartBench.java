package lightning.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.stream.Stream;
import lightning.base.work.Progress;
import lightning.format.pov.PovRayRunner;
import lightning.format.pov.PovScene;

/** Benchmark of cold-start processes that render an image: ours, in turns with POV-Ray if installed. */
final class ColdStartBench {
    /** Predicted start time of a process in milliseconds, and its trace time relative to a warm full trace. */
    private static final double START_MS = 1000;
    private static final double COLD_SLOWDOWN = 20;

    private final BenchSettings settings;
    private final ResultCollector ledger;

    ColdStartBench(BenchSettings settings, ResultCollector ledger) {
        this.settings = settings;
        this.ledger = ledger;
    }

    /** Returns the measurement; a failure of a program becomes a failed measurement. */
    BenchPart part(ResultCollector.SceneCollector collector, NamedScene scene, PictureSize size, TraceThroughput throughput) {
        Optional<PovRayRunner> povRay = PovRayRunner.find();
        String title = scene.name() + " at " + size + ", from cold";
        double processMs = START_MS + COLD_SLOWDOWN * throughput.fullMs(size);
        return new BenchPart(title, (settings.processes() + 1) * processMs * (povRay.isPresent() ? 2 : 1), progress -> {
            try {
                collector.setColdStart(measure(scene, size, povRay, progress));
            } catch (IOException e) {
                ledger.addProblem(new MeasurementFailure(MeasurementFailure.Kind.UNMEASURED, title, e.getMessage()));
            }
        });
    }

    private ColdStart measure(NamedScene scene, PictureSize size, Optional<PovRayRunner> povRay, Progress progress)
            throws IOException, InterruptedException {
        var ours = new ProcessTimer();
        var rival = new ProcessTimer();
        PovScene exported = PovScene.of(size.of(scene.scene()), "scene");
        Path folder = Files.createTempDirectory("lightning-cold");
        try {
            ProcessTimer.ProcessRun render =
                    () -> RenderProcess.render(scene.file(), size, settings.threads(), folder.resolve("picture.png"), folder);
            // Loads files into the page cache.
            render.run();
            for (int i = 0; i < settings.processes(); i++) {
                if (progress.isCanceled()) {
                    throw new CancellationException("canceled after " + i + " of " + settings.processes() + " processes");
                }
                ours.measure(render);
                if (povRay.isPresent()) {
                    povRay.get().runWrapped(exported, size.width(), size.height(), settings.threads(),
                            process -> rival.measure(process::run));
                }
                progress.report(i + 1, settings.processes());
            }
        } finally {
            delete(folder);
        }
        TimeSamples process = ours.wallTime();
        return new ColdStart(process, ours.processorTime(),
                povRay.isEmpty() ? null : new ColdStart.Rival(PovRayBench.PROGRAM, rival.wallTime(),
                        rival.processorTime(), process.median() / rival.wallTime().median()));
    }

    private static void delete(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(file);
            }
        }
    }
}
