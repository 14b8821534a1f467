package lightning.render.warmup;

import java.util.concurrent.CancellationException;
import java.util.stream.IntStream;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.engine.Engine;
import lightning.render.engine.choice.Engines;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import lightning.render.trace.Geometry;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;

/**
 * Warm-up of this process's lane engine: renders some tiles of an image, which are discarded, on the calling thread only.
 *
 * <p>The tiles lack gathered light and blurred reflections: their rays use the same kernels, but are cast for the whole image, which would take seconds
 * each time.
 *
 * <p>Lanes are interpreted until they are compiled, and are then far slower than scalar loops. So both engines render the same
 * tiles in turn until the lanes were faster several times in a row; only then the process uses them.
 */
public final class WarmUp {
    /** Time of enough tiles, milliseconds. */
    private static final double ENOUGH_MS = 100;
    private static final int REQUIRED_WINS = 4;

    private WarmUp() {}

    /**
     * Warms up the lanes and switches the process to them; does nothing if they are already in use.
     *
     * @param scene scene to trace
     * @param geometry geometry that can serve the scene
     * @throws CancellationException if {@code progress} requested to stop; code compiled by then stays compiled
     */
    public static void run(Scene scene, Geometry geometry, Progress progress) {
        if (Engines.isFastestInUse()) {
            return;
        }
        if (Engines.hasLanes()) {
            SampleTiles sampleTiles = SampleTiles.of(scene, geometry, progress);
            int wins = 0;
            while (wins < REQUIRED_WINS) {
                double scalarTime = sampleTiles.measureMilliseconds(Engines.SCALAR, progress);
                double laneTime = sampleTiles.measureMilliseconds(Engines.LANES, progress);
                wins = laneTime < scalarTime ? wins + 1 : 0;
            }
        }
        Engines.use(Engines.FASTEST);
    }

    /** Some tiles of an image without samples at edges, rendered repeatedly. */
    private record SampleTiles(TraditionalTracer tracer, int[] tiles) {
        /** Returns tiles that the scalar engine renders in some time, or all tiles. */
        static SampleTiles of(Scene scene, Geometry geometry, Progress progress) {
            PictureSettings picture = scene.picture();
            Scene centers = scene.withPicture(picture.withSampling(SamplingSettings.DEFAULT));
            int all = Film.tilesAlong(picture.width()) * Film.tilesAlong(picture.height());
            var tracer = new TraditionalTracer(centers, geometry);
            int count = 1;
            var some = new SampleTiles(tracer, tiles(all, count));
            while (count < all && some.measureMilliseconds(Engines.SCALAR, progress) < ENOUGH_MS) {
                count = Math.min(2 * count, all);
                some = new SampleTiles(tracer, tiles(all, count));
            }
            return some;
        }

        /** Returns tiles that are spread over the whole image. */
        private static int[] tiles(int all, int count) {
            return IntStream.range(0, count).map(i -> (int) ((2L * i + 1) * all / (2 * count))).toArray();
        }

        double measureMilliseconds(Engine engine, Progress progress) {
            try (WorkerPool singleWorker = new WorkerPool(1)) {
                long start = System.nanoTime();
                tracer.withEngines(_ -> engine).traceDirectLight(singleWorker, tiles, progress.cancellationOnly());
                return (System.nanoTime() - start) / 1e6;
            }
        }
    }
}
