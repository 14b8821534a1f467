package lightning.bench.accuracy;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.measure.InterleavedTimer;
import lightning.render.measure.Timing;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.shading.RayCounts;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Times of a scene's first pass and of edits that each start from its cache, measured in turns. For scenes whose full trace takes too long
 * to be measured in turns with each edit: each edit's full trace, which checks its image, is timed once.
 *
 * @param first     first passes
 * @param edits     updates of each edit
 * @param fullTrace full traces of the edited scenes; null if no image was checked
 * @param equal     whether the image of each edit is equal to its full trace in every bit; empty if not checked
 * @param bytes     bytes of the cache
 * @param rays      rays of the first pass
 * @param points    gather points of indirect light
 * @param surfels   surfels of indirect light
 */
public record EditTurns(Timing first, List<Timing> edits, @Nullable Timing fullTrace, List<Boolean> equal, long bytes, RayCounts rays,
        int points, int surfels) {
    /** Size in bytes from which a discarded cache causes notable garbage collection. */
    private static final long LARGE = 1 << 24;
    /** Updates that take less time are measured several times in each turn. */
    private static final double SHORT_MS = 300;
    private static final int SHORT_REPETITIONS = 3;

    public EditTurns {
        edits = List.copyOf(edits);
        equal = List.copyOf(equal);
    }

    /**
     * Measures a scene, after one turn for warm-up.
     *
     * @param afters scenes after one edit each
     * @param turns  number of turns, ≥ 1
     * @param compares whether to compare the image after each edit with a full trace
     * @throws java.util.concurrent.CancellationException if {@code progress} requests a stop
     */
    public static EditTurns of(Scene before, List<Scene> afters, RenderOptions options, int turns, boolean compares, Progress progress) {
        try (Renderer renderer = new Renderer(options.withEngines(Engines.FASTEST));
                WorkerPool workers = new WorkerPool(options.threads())) {
            return measure(renderer, workers, before, afters, turns, compares, progress);
        }
    }

    private static EditTurns measure(Renderer renderer, WorkerPool workers, Scene before, List<Scene> afters, int turns, boolean compares,
            Progress progress) {
        Progress silent = progress.cancellationOnly();
        List<Double> first = new ArrayList<>();
        List<List<Double>> edits = new ArrayList<>();
        afters.forEach(_ -> edits.add(new ArrayList<>()));
        PixelCache cache = null;
        UpdateResult firstPass = null;
        for (int turn = -1; turn < turns; turn++) {
            boolean isLarge = cache != null && cache.bytes() > LARGE;
            renderer.clear();
            cache = null;
            if (isLarge) {
                // Collects garbage here, as a pause during timing is longer than most edits.
                System.gc();
            }
            firstPass = renderer.render(before, silent);
            cache = renderer.cache();
            for (int i = 0; i < afters.size(); i++) {
                double ms = 0;
                for (int n = 0; n == 0 || n < SHORT_REPETITIONS && ms < SHORT_MS; n++) {
                    renderer.restore(cache);
                    ms = renderer.render(afters.get(i), silent).milliseconds();
                    if (turn >= 0) {
                        edits.get(i).add(ms);
                    }
                }
            }
            if (turn >= 0) {
                first.add(firstPass.milliseconds());
            }
            progress.report(turn + 2, turns + 1);
        }
        assert cache != null && firstPass != null;
        List<Double> full = new ArrayList<>();
        List<Boolean> equal = new ArrayList<>();
        for (int i = 0; i < afters.size() && compares; i++) {
            renderer.restore(cache);
            renderer.render(afters.get(i), silent);
            TraditionalTracer tracer = new TraditionalTracer(afters.get(i)).withEngines(Engines.FASTEST);
            Film[] film = new Film[1];
            full.add(InterleavedTimer.timeMs(() -> film[0] = tracer.trace(workers, silent).film()));
            equal.add(renderer.film().hasSameBits(film[0]));
        }
        var indirect = cache.indirect();
        return new EditTurns(new Timing(first), edits.stream().map(Timing::new).toList(), full.isEmpty() ? null : new Timing(full), equal,
                cache.bytes(), firstPass.rays(), indirect == null ? 0 : indirect.structure().pointCount(),
                indirect == null ? 0 : indirect.structure().surfelCount());
    }
}
