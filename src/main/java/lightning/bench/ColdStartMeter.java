package lightning.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import lightning.base.file.TemporaryFolder;
import lightning.base.work.Progress;
import lightning.bench.result.ColdStart;
import lightning.bench.result.TimeSamples;
import lightning.format.pov.PovRayRunner;
import lightning.format.pov.PovSampling;
import lightning.format.pov.PovScene;
import lightning.scene.Scene;

/**
 * Meter of whole processes that render an image: ours, in turns with POV-Ray's if installed.
 *
 * @param threads   number of threads of each process
 * @param processes maximum number of processes of each program, ≥ 1
 * @param maxMs     time after which no further pair of processes is started, milliseconds
 */
record ColdStartMeter(int threads, int processes, double maxMs) {
    /** Size of an image that is rendered first, so that files are in the page cache. */
    private static final PictureSize WARM_UP_SIZE = new PictureSize(32, 24);

    /**
     * Measures a scene.
     *
     * @param scene   scene with the sampling of {@code options}, for POV-Ray
     * @param options options of {@code lightning render}
     * @throws IOException          if a process fails
     * @throws InterruptedException if this thread was interrupted
     */
    ColdStart measure(Path file, Scene scene, PictureSize size, List<String> options, PovSampling sampling, Progress progress)
            throws IOException, InterruptedException {
        Optional<PovRayRunner> povRay = PovRayRunner.find();
        var ours = new ProcessTimer();
        var rival = new ProcessTimer();
        PovScene exported = PovScene.of(size.of(scene), "scene");
        Path folder = Files.createTempDirectory("lightning-cold");
        try {
            Path picture = folder.resolve("picture.png");
            RenderProcess.render(file, WARM_UP_SIZE, threads, options, picture, folder);
            long start = System.nanoTime();
            for (int i = 0; i < processes && (i == 0 || System.nanoTime() - start < maxMs * 1e6); i++) {
                progress.checkCanceled("canceled after " + i + " of " + processes + " processes");
                ours.measure(() -> RenderProcess.render(file, size, threads, options, picture, folder));
                if (povRay.isPresent()) {
                    povRay.get().runWrapped(exported, size.width(), size.height(), threads, sampling,
                            process -> rival.measure(process::run));
                }
                progress.report(i + 1, processes);
            }
        } finally {
            TemporaryFolder.delete(folder);
        }
        TimeSamples process = ours.wallTime();
        return new ColdStart(process, ours.processorTime(),
                povRay.isEmpty() ? null : new ColdStart.Rival(PovRayBench.PROGRAM, rival.wallTime(),
                        rival.processorTime(), process.median() / rival.wallTime().median()));
    }
}
