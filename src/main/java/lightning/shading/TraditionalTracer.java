package lightning.shading;

import java.util.Arrays;
import java.util.stream.IntStream;
import lightning.image.Film;
import lightning.scene.Scene;
import lightning.trace.Geometry;
import lightning.trace.HitRows;
import lightning.trace.PacketTracer;
import lightning.trace.TileVisibility;

/**
 * The yardstick of every saving: a full trace by the fastest code there is, tile by tile, which keeps
 * nothing but the film.
 */
public final class TraditionalTracer {
    private final Geometry geometry;
    private final Geometry mirroredGeometry;
    private final Scene scene;
    private final Scene mirrored;
    private final Lamp[] lamps;
    private final Lamp[] mirroredLamps;

    /** Prepares a trace, the tree of boxes included. */
    public TraditionalTracer(Scene scene) {
        this(scene, new Geometry(scene));
    }

    /**
     * Prepares a trace over geometry that is there already.
     *
     * @throws IllegalArgumentException if it does not serve the scene
     */
    public TraditionalTracer(Scene scene, Geometry geometry) {
        this(scene, scene, geometry);
    }

    /**
     * Prepares a trace of {@code scene} whose mirrors show {@code mirrored}: what a picture with stale
     * reflections must be (paper §4.8). The two may differ in lights, world and materials.
     *
     * @throws IllegalArgumentException if the geometry does not serve both
     */
    public TraditionalTracer(Scene scene, Scene mirrored, Geometry geometry) {
        this.scene = scene;
        this.mirrored = mirrored;
        this.geometry = geometry.of(scene);
        mirroredGeometry = geometry.of(mirrored);
        lamps = lamps(scene);
        mirroredLamps = lamps(mirrored);
    }

    private static Lamp[] lamps(Scene scene) {
        return scene.lights().stream().map(light -> Lamp.of(light, scene)).toArray(Lamp[]::new);
    }

    /** A finished picture and the rays it took. */
    public record Result(Film film, TraceCounts rays) {}

    /**
     * Traces the whole picture.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} asked to stop
     */
    public Result trace(Workers workers, Progress progress) {
        return trace(workers, allTiles(), progress);
    }

    private int[] allTiles() {
        int across = (scene.picture().width() - 1) / Film.TILE + 1;
        int down = (scene.picture().height() - 1) / Film.TILE + 1;
        return IntStream.range(0, across * down).toArray();
    }

    /**
     * Traces some tiles; the others stay black.
     *
     * @param tiles the numbers of the film's tiles that are wanted
     * @throws java.util.concurrent.CancellationException if {@code progress} asked to stop
     */
    public Result trace(Workers workers, int[] tiles, Progress progress) {
        Film film = Film.black(scene.picture().width(), scene.picture().height());
        PerThread[] threads = new PerThread[workers.count()];
        Arrays.setAll(threads, _ -> new PerThread());
        workers.run(tiles.length, (worker, i) -> threads[worker].tile(film, tiles[i], progress), progress);
        TraceCounts rays = TraceCounts.NONE;
        for (PerThread thread : threads) {
            rays = rays.plus(thread.rays());
        }
        return new Result(film, rays);
    }

    /** What one thread needs of the first level, or of those in mirrors. */
    private static final class Side {
        private final TileVisibility visibility;
        private final LightKernel lights;
        private final TileComposer composer;

        Side(Geometry geometry, Scene scene, PacketTracer tracer) {
            visibility = new TileVisibility(geometry, scene, tracer);
            lights = new LightKernel(geometry, tracer, ViewEffects.ALL);
            composer = new TileComposer(geometry.materials(), ViewEffects.ALL);
        }
    }

    /** What one thread needs. */
    private final class PerThread {
        private final Side eye;
        private final Side mirrors;
        private final ScratchColumns columns = new ScratchColumns();
        private final HitRows[] levels = new HitRows[scene.picture().depth() + 1];
        private final LightLayer[] layers = new LightLayer[Math.max(lamps.length, mirroredLamps.length)];
        private long eyeRays;
        private long reflected;

        PerThread() {
            PacketTracer tracer = new PacketTracer(geometry);
            eye = new Side(geometry, scene, tracer);
            mirrors = geometry == mirroredGeometry ? eye : new Side(mirroredGeometry, mirrored, tracer);
        }

        TraceCounts rays() {
            return new TraceCounts(eyeRays, reflected, eye.lights.shadowRays() + (mirrors == eye ? 0 : mirrors.lights.shadowRays()));
        }

        void tile(Film film, int tile, Progress progress) {
            int x0 = tile % film.tilesX() * Film.TILE;
            int y0 = tile / film.tilesX() * Film.TILE;
            HitRows rows = eye.visibility.eye(x0, y0, Film.TILE, (count, textured) -> level(0));
            eyeRays += (long) Math.min(Film.TILE, film.width() - x0) * Math.min(Film.TILE, film.height() - y0);
            int deepest = 0;
            while (deepest < scene.picture().depth() && rows.reflective > 0) {
                int next = deepest + 1;
                reflected += rows.reflective;
                rows = mirrors.visibility.mirrored(rows, null, (count, textured) -> level(next));
                deepest = next;
            }
            float[][] cr = mirrors.composer.unfollowed(levels[deepest]);
            for (int k = deepest; k > 0 && !progress.isCancelled(); k--) {
                compose(mirrors, k, mirroredLamps, mirrored, cr, progress);
                cr = mirrors.composer.followed(levels[k - 1], levels[k], mirrored.world());
            }
            compose(eye, 0, lamps, scene, cr, progress);
            if (!progress.isCancelled()) {
                eye.composer.toFilm(levels[0], scene.world(), film.red(tile), film.green(tile), film.blue(tile));
            }
        }

        private HitRows level(int k) {
            if (levels[k] == null) {
                levels[k] = new HitRows(Film.TILE_PIXELS, true);
            }
            return levels[k];
        }

        private void compose(Side side, int k, Lamp[] lamps, Scene shown, float[][] cr, Progress progress) {
            columns.reset();
            for (int l = 0; l < lamps.length && !progress.isCancelled(); l++) {
                layers[l] = lamps[l].isDark() ? null : side.lights.full(levels[k], lamps[l], columns);
            }
            if (!progress.isCancelled()) {
                side.composer.level(levels[k], lamps, layers, null, shown.world(), cr);
            }
        }
    }
}
