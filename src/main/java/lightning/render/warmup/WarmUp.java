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
 * Brings the lanes of this process to speed where nobody waits for what they make: by small copies of a picture that nobody
 * sees, on the thread that asks and no other.
 *
 * <p>Lanes are interpreted until they are compiled and are then slower than plain loops by far. So the same picture is made
 * both ways, in turns, until the lanes have been faster several times running; only then the process's tiles come from them.
 */
public final class WarmUp {
    /** The longer side of the small picture, pixels: enough tiles to run all kernels, each of them made both ways. */
    private static final int SIDE = 160;
    private static final int REQUIRED_WINS = 4;

    private WarmUp() {}

    /**
     * Warms the lanes up and lets the process use them; does nothing where it does already.
     *
     * @param scene    what is traced
     * @param geometry serves it
     * @throws CancellationException if {@code progress} asked to stop; what is compiled by then stays so
     */
    public static void run(Scene scene, Geometry geometry, Progress progress) {
        if (Engines.isFastestInUse()) {
            return;
        }
        if (Engines.hasLanes()) {
            SmallRender smallRender = new SmallRender(scene, geometry);
            int wins = 0;
            while (wins < REQUIRED_WINS) {
                double scalarTime = smallRender.measureMilliseconds(Engines.SCALAR, progress);
                double laneTime = smallRender.measureMilliseconds(Engines.LANES, progress);
                wins = laneTime < scalarTime ? wins + 1 : 0;
            }
        }
        Engines.use(Engines.FASTEST);
    }

    /** A small picture of a scene, made again and again. */
    private record SmallRender(TraditionalTracer tracer, int[] tiles) {
        SmallRender(Scene scene, Geometry geometry) {
            this(new TraditionalTracer(shrink(scene), geometry), tiles(shrink(scene).picture()));
        }

        private static Scene shrink(Scene scene) {
            PictureSettings p = scene.picture();
            double shrink = Math.max(1, (double) Math.max(p.width(), p.height()) / SIDE);
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
