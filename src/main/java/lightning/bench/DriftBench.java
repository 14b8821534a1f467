package lightning.bench;

import java.util.ArrayList;
import java.util.Arrays;
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

/** Measures what becomes of a picture after 1, 10, 100, … edits, at each accuracy. */
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
        List<Renderer> renderers = Arrays.stream(Accuracy.values())
                .map(accuracy -> new Renderer(CURRENT.withAccuracy(accuracy).withThreads(threads))).toList();
        int[] refreshes = new int[renderers.size()];
        try (Workers workers = new Workers(threads)) {
            for (Renderer renderer : renderers) {
                renderer.render(wanted, progress.silent());
            }
            int next = 1;
            for (int n = 1; n <= most; n++) {
                wanted = edits.next(wanted);
                Update[] updates = new Update[refreshes.length];
                for (int i = 0; i < updates.length; i++) {
                    updates[i] = renderers.get(i).render(wanted, progress.silent());
                    refreshes[i] += updates[i].refreshed() ? 1 : 0;
                }
                if (n == next) {
                    Film full = new TraditionalTracer(wanted, renderers.getFirst().cache().geometry()).trace(workers, progress.silent())
                            .film();
                    for (int i = 0; i < updates.length; i++) {
                        Renderer renderer = renderers.get(i);
                        points.add(new DriftPoint(renderer.options().accuracy(), n, PictureError.of(renderer.film(), full),
                                updates[i].errorBound(), refreshes[i]));
                    }
                    next *= 10;
                }
                progress.tiles(n, most);
            }
        } finally {
            renderers.forEach(Renderer::close);
        }
        return new Drift(named.name(), scene.picture().width(), scene.picture().height(), seed, points);
    }
}
