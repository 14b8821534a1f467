package lightning.bench;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.bench.accuracy.RandomEdits;
import lightning.bench.result.DriftCurve;
import lightning.bench.result.DriftPoint;
import lightning.render.RenderOptions;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.measure.PictureError;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.paper.Accuracy;
import lightning.scene.Scene;

/** Benchmark of image error after 1, 10, 100, … edits, at each accuracy. */
record DriftBench(NamedScene named, PictureSize size, int threads, long seed) {
    /** @param editCount number of edits at the end */
    DriftCurve measure(int editCount, Progress progress) {
        RandomEdits edits = new RandomEdits(seed);
        List<DriftPoint> points = new ArrayList<>();
        Scene target = size.of(named.scene());
        List<Renderer> renderers = Arrays.stream(Accuracy.values())
                .map(accuracy -> new Renderer(RenderOptions.DEFAULT.withAccuracy(accuracy).withThreads(threads))).toList();
        int[] refreshes = new int[renderers.size()];
        try (WorkerPool workers = new WorkerPool(threads)) {
            for (Renderer renderer : renderers) {
                renderer.render(target, progress.cancellationOnly());
            }
            int next = 1;
            for (int n = 1; n <= editCount; n++) {
                target = edits.next(target);
                UpdateResult[] updates = new UpdateResult[refreshes.length];
                for (int i = 0; i < updates.length; i++) {
                    updates[i] = renderers.get(i).render(target, progress.cancellationOnly());
                    refreshes[i] += updates[i].wasRefreshed() ? 1 : 0;
                }
                if (n == next) {
                    Film full = new TraditionalTracer(target, renderers.getFirst().cache().geometry())
                            .trace(workers, progress.cancellationOnly())
                            .film();
                    for (int i = 0; i < updates.length; i++) {
                        Renderer renderer = renderers.get(i);
                        points.add(new DriftPoint(renderer.options().accuracy(), n, PictureError.of(renderer.film(), full),
                                updates[i].errorBound(), refreshes[i]));
                    }
                    next *= 10;
                }
                progress.report(n, editCount);
            }
        } finally {
            renderers.forEach(Renderer::close);
        }
        return new DriftCurve(named.name(), size.width(), size.height(), seed, points);
    }
}
