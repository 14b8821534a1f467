package lightning.bench;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.bench.accuracy.OrdinaryEdits;
import lightning.bench.accuracy.PictureError;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.relight.Renderer;
import lightning.render.relight.Update;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.tile.Options;
import lightning.scene.Scene;

/** Measures what becomes of a picture after 1, 10, 100, … edits, at the grades ratio and exact. */
final class DriftBench {
    private static final Options CURRENT = Options.DEFAULT.withReflections(Reflections.CURRENT);

    private final NamedScene named;
    private final Scene scene;
    private final int threads;
    private final long seed;

    DriftBench(NamedScene named, PictureSize size, int threads, long seed) {
        this.named = named;
        scene = size.of(named.scene());
        this.threads = threads;
        this.seed = seed;
    }

    /** @param most the number of edits at the end */
    Drift measure(int most, Progress progress) {
        OrdinaryEdits edits = new OrdinaryEdits(seed);
        List<DriftPoint> points = new ArrayList<>();
        Scene wanted = scene;
        int refreshes = 0;
        try (Workers workers = new Workers(threads);
                Renderer ratio = new Renderer(CURRENT.withAccuracy(Accuracy.RATIO).withThreads(threads));
                Renderer exact = new Renderer(CURRENT.withAccuracy(Accuracy.EXACT).withThreads(threads))) {
            ratio.render(wanted, progress.silent());
            exact.render(wanted, progress.silent());
            int next = 1;
            for (int n = 1; n <= most; n++) {
                wanted = edits.next(wanted);
                Update update = ratio.render(wanted, progress.silent());
                exact.render(wanted, progress.silent());
                refreshes += update.refreshed() ? 1 : 0;
                if (n == next) {
                    Film full = new TraditionalTracer(wanted, exact.cache().geometry()).trace(workers, progress.silent()).film();
                    points.add(new DriftPoint(Accuracy.RATIO, n, PictureError.of(ratio.film(), full), update.errorBound(), refreshes));
                    points.add(new DriftPoint(Accuracy.EXACT, n, PictureError.of(exact.film(), full), 0, 0));
                    next *= 10;
                }
                progress.tiles(n, most);
            }
        }
        return new Drift(named.name(), scene.picture().width(), scene.picture().height(), seed, points);
    }
}
