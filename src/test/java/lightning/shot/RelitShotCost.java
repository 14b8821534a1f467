package lightning.shot;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicLong;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.format.jen.PropertyEdit;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.relight.tile.Options;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;

/** What it takes to relight all frames of scenes/dusk.jen, from memory and from disk, beside tracing each; run by hand. */
final class RelitShotCost {
    private static final int FRAMES = 48;

    private RelitShotCost() {}

    public static void main(String... args) throws Exception {
        JenDocument document = JenReader.read(Path.of("scenes/dusk.jen"));
        Scene scene = document.scene().withPicture(document.scene().picture().withSize(640, 360));
        Shot keys = document.shot().orElseThrow();
        Take first = new Take(scene, keys);
        Take weight = new Take(PropertyEdit.apply(scene, "beam.intensity=2", Path.of("scenes")), keys);
        Take ambience = new Take(PropertyEdit.apply(scene, "world.ambience=0.5", Path.of("scenes")), keys);
        Take moved = new Take(PropertyEdit.apply(scene, "sky.at=0 5 5", Path.of("scenes")), keys);
        Path place = Files.createTempDirectory("shelf");
        for (int turn = 0; turn < 3; turn++) {
            System.out.printf(Locale.ROOT, "full traces %.0f ms%n", full(first));
            for (boolean onDisk : new boolean[] {false, true}) {
                LocalKeeper keeper = onDisk ? new LocalKeeper(Options.DEFAULT, 0, place, Long.MAX_VALUE)
                        : new LocalKeeper(Options.DEFAULT, Long.MAX_VALUE);
                var work = new AtomicLong();
                ShotListener listener = new ShotListener() {
                    @Override
                    public void updated(FrameUpdate update, FrameState state) {
                        work.addAndGet(update.nanoseconds());
                    }
                };
                try (RelitShot shot = RelitShot.of(1, FRAMES, keeper, listener)) {
                    for (Take take : new Take[] {first, weight, ambience, moved, first}) {
                        work.set(0);
                        shot.edit(take);
                        shot.awaitIdle();
                        String name = take == weight ? "weight" : take == ambience ? "ambience" : take == moved ? "moved" : "first/back";
                        System.out.printf(Locale.ROOT, "  %s %-10s %.0f ms, %s%n", onDisk ? "disk  " : "memory", name, work.get() / 1e6,
                                shot.bytes());
                    }
                }
            }
        }
        Files.delete(place);
    }

    private static double full(Take take) {
        long start = System.nanoTime();
        try (Workers workers = new Workers(Workers.available())) {
            for (int frame = 1; frame <= FRAMES; frame++) {
                new TraditionalTracer(take.at(frame)).trace(workers, Progress.NONE);
            }
        }
        return (System.nanoTime() - start) / 1e6;
    }
}
