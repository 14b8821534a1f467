package lightning.shot;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicLong;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.format.jen.PropertyEdit;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;

/** Measures relighting all frames of scenes/dusk.jen, from memory and from disk, against tracing each; run by hand. */
final class ShotRelighterCost {
    private static final int FRAMES = 48;

    private ShotRelighterCost() {}

    public static void main(String... args) throws Exception {
        JenDocument document = JenReader.read(Path.of("scenes/dusk.jen"));
        Scene scene = document.scene().withPicture(document.scene().picture().withSize(640, 360));
        Shot keys = document.shot().orElseThrow();
        ShotRevision first = new ShotRevision(scene, keys);
        ShotRevision weight = new ShotRevision(PropertyEdit.apply(scene, "beam.intensity=2", Path.of("scenes")), keys);
        ShotRevision ambience = new ShotRevision(PropertyEdit.apply(scene, "world.ambience=0.5", Path.of("scenes")), keys);
        ShotRevision moved = new ShotRevision(PropertyEdit.apply(scene, "sky.at=0 5 5", Path.of("scenes")), keys);
        Path folder = Files.createTempDirectory("shelf");
        for (int turn = 0; turn < 3; turn++) {
            System.out.printf(Locale.ROOT, "full traces %.0f ms%n", full(first));
            for (boolean onDisk : new boolean[] {false, true}) {
                LocalFrameHost host = onDisk ? new LocalFrameHost(RenderOptions.DEFAULT, 0, folder, Long.MAX_VALUE)
                        : new LocalFrameHost(RenderOptions.DEFAULT, Long.MAX_VALUE);
                var work = new AtomicLong();
                ShotListener listener = new ShotListener() {
                    @Override
                    public void frameUpdated(FrameUpdate update, FrameState state) {
                        work.addAndGet(update.nanoseconds());
                    }
                };
                try (ShotRelighter shot = ShotRelighter.of(1, FRAMES, host, listener)) {
                    for (ShotRevision revision : new ShotRevision[] {first, weight, ambience, moved, first}) {
                        work.set(0);
                        shot.setRevision(revision);
                        shot.awaitIdle();
                        String name = revision == weight ? "weight" : revision == ambience ? "ambience"
                                : revision == moved ? "moved" : "first/back";
                        System.out.printf(Locale.ROOT, "  %s %-10s %.0f ms, %s%n", onDisk ? "disk  " : "memory", name, work.get() / 1e6,
                                shot.usage());
                    }
                }
            }
        }
        Files.delete(folder);
    }

    private static double full(ShotRevision revision) {
        long start = System.nanoTime();
        try (WorkerPool workers = new WorkerPool(WorkerPool.processorCount())) {
            for (int frame = 1; frame <= FRAMES; frame++) {
                new TraditionalTracer(revision.sceneAt(frame)).trace(workers, Progress.NONE);
            }
        }
        return (System.nanoTime() - start) / 1e6;
    }
}
