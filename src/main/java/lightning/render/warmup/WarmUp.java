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
import lightning.scene.Scene;

/**
 * Warm-up of this process's lane engine: renders small copies of an image, which are discarded, on the calling thread only.
 *
 * <p>Lanes are interpreted until they are compiled, and are then far slower than scalar loops. So both engines render the same
 * image in turn until the lanes were faster several times in a row; only then the process uses them.
 */
public final class WarmUp {
    /** Longer side of the small image, pixels: enough tiles to run all kernels with both engines. */
    private static final int SIDE = 160;
    /** Longer side of the smallest image, for scenes whose pixels take long. */
    private static final int MIN_SIDE = 20;
    /** Time of an image that is large enough, milliseconds. */
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
            SmallRender smallRender = SmallRender.of(scene, geometry, progress);
            int wins = 0;
            while (wins < REQUIRED_WINS) {
                double scalarTime = smallRender.measureMilliseconds(Engines.SCALAR, progress);
                double laneTime = smallRender.measureMilliseconds(Engines.LANES, progress);
                wins = laneTime < scalarTime ? wins + 1 : 0;
            }
        }
        Engines.use(Engines.FASTEST);
    }

    /** Small image of a scene, rendered repeatedly. */
    private record SmallRender(TraditionalTracer tracer, int[] tiles) {
        /** Returns an image that the scalar engine renders in some time, or the largest one. */
        static SmallRender of(Scene scene, Geometry geometry, Progress progress) {
            int side = MIN_SIDE;
            SmallRender render = ofSide(scene, geometry, side);
            while (side < SIDE && render.measureMilliseconds(Engines.SCALAR, progress) < ENOUGH_MS) {
                side *= 2;
                render = ofSide(scene, geometry, side);
            }
            return render;
        }

        private static SmallRender ofSide(Scene scene, Geometry geometry, int side) {
            Scene small = shrink(scene, side);
            return new SmallRender(new TraditionalTracer(small, geometry), tiles(small.picture()));
        }

        private static Scene shrink(Scene scene, int side) {
            PictureSettings p = scene.picture();
            double shrink = Math.max(1, (double) Math.max(p.width(), p.height()) / side);
            return scene.withPicture(p.withSize(Math.max(1, (int) (p.width() / shrink)), Math.max(1, (int) (p.height() / shrink))));
        }

        private static int[] tiles(PictureSettings p) {
            return IntStream.range(0, Film.tilesAlong(p.width()) * Film.tilesAlong(p.height())).toArray();
        }

        double measureMilliseconds(Engine engine, Progress progress) {
            try (WorkerPool singleWorker = new WorkerPool(1)) {
                long start = System.nanoTime();
                tracer.withEngines(_ -> engine).trace(singleWorker, tiles, progress.cancellationOnly());
                return (System.nanoTime() - start) / 1e6;
            }
        }
    }
}
