package lightning.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.stream.Stream;
import lightning.base.work.Progress;
import lightning.format.pov.PovRay;
import lightning.format.pov.PovScene;

/** Measures whole processes that render a picture from cold: ours, and POV-Ray's in turns with them where it is installed. */
final class ColdBench {
    /** A process takes about so long to start, and to trace so many times as long as a warm full trace. */
    private static final double START_MS = 1000;
    private static final double SLOWER = 20;

    private final Settings settings;
    private final Ledger ledger;

    ColdBench(Settings settings, Ledger ledger) {
        this.settings = settings;
        this.ledger = ledger;
    }

    /** What is to be measured; where a program fails, that becomes a problem. */
    Part part(Ledger.Page page, NamedScene scene, PictureSize size, Pace pace) {
        Optional<PovRay> povRay = PovRay.find();
        String where = scene.name() + " at " + size + ", from cold";
        double each = START_MS + SLOWER * pace.fullMs(size);
        return new Part(where, (settings.processes() + 1) * each * (povRay.isPresent() ? 2 : 1), progress -> {
            try {
                page.cold(measure(scene, size, povRay, progress));
            } catch (IOException e) {
                ledger.problem(new Failure(Failure.Kind.UNMEASURED, where, e.getMessage()));
            }
        });
    }

    private Cold measure(NamedScene scene, PictureSize size, Optional<PovRay> povRay, Progress progress)
            throws IOException, InterruptedException {
        var ours = new ProcessTimes();
        var theirs = new ProcessTimes();
        PovScene exported = PovScene.of(size.of(scene.scene()), "scene");
        Path folder = Files.createTempDirectory("lightning-cold");
        try {
            ProcessTimes.Work render =
                    () -> OwnProcess.render(scene.file(), size, settings.threads(), folder.resolve("picture.png"), folder);
            // Files come into memory.
            render.run();
            for (int i = 0; i < settings.processes(); i++) {
                if (progress.isCancelled()) {
                    throw new CancellationException("cancelled after " + i + " of " + settings.processes() + " processes");
                }
                ours.measure(render);
                if (povRay.isPresent()) {
                    povRay.get().process(exported, size.width(), size.height(), settings.threads(),
                            process -> theirs.measure(process::run));
                }
                progress.tiles(i + 1, settings.processes());
            }
        } finally {
            delete(folder);
        }
        Samples process = ours.wall();
        return new Cold(process, ours.processor(), povRay.isEmpty() ? null : new Cold.Rival(PovPeer.PROGRAM, theirs.wall(),
                theirs.processor(), process.median() / theirs.wall().median()));
    }

    private static void delete(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(file);
            }
        }
    }
}
