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
     * @throws IllegalArgumentException if it is not the scene's
     */
    public TraditionalTracer(Scene scene, Geometry geometry) {
        this(scene, scene, geometry);
    }

    /**
     * Prepares a trace of {@code scene} whose mirrors show {@code mirrored}: what a picture with stale
     * reflections must be (paper §4.8). The two may differ in lights and world.
     *
     * @throws IllegalArgumentException if the geometry is not that of both
     */
    public TraditionalTracer(Scene scene, Scene mirrored, Geometry geometry) {
        if (!geometry.serves(scene) || !geometry.serves(mirrored)) {
            throw new IllegalArgumentException("the geometry is another scene's");
        }
        this.scene = scene;
        this.mirrored = mirrored;
        this.geometry = geometry;
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
            rays = rays.plus(new TraceCounts(thread.eye, thread.reflected, thread.lights.shadowRays()));
        }
        return new Result(film, rays);
    }

    /** What one thread needs. */
    private final class PerThread {
        private final PacketTracer tracer = new PacketTracer(geometry);
        private final TileVisibility visibility = new TileVisibility(geometry, scene, tracer);
        private final LightKernel lights = new LightKernel(geometry, tracer, ViewEffects.ALL);
        private final TileComposer composer = new TileComposer(geometry.materials(), ViewEffects.ALL);
        private final ScratchColumns columns = new ScratchColumns();
        private final HitRows[] levels = new HitRows[scene.picture().depth() + 1];
        private final LightLayer[] layers = new LightLayer[Math.max(lamps.length, mirroredLamps.length)];
        private long eye;
        private long reflected;

        void tile(Film film, int tile, Progress progress) {
            int x0 = tile % film.tilesX() * Film.TILE;
            int y0 = tile / film.tilesX() * Film.TILE;
            HitRows rows = visibility.eye(x0, y0, Film.TILE, (count, textured) -> level(0));
            eye += (long) Math.min(Film.TILE, film.width() - x0) * Math.min(Film.TILE, film.height() - y0);
            int deepest = 0;
            while (deepest < scene.picture().depth() && rows.reflective > 0) {
                int next = deepest + 1;
                reflected += rows.reflective;
                rows = visibility.mirrored(rows, null, (count, textured) -> level(next));
                deepest = next;
            }
            for (int k = deepest; k >= 0; k--) {
                Lamp[] shining = k == 0 ? lamps : mirroredLamps;
                light(levels[k], shining, progress);
                if (progress.isCancelled()) {
                    return;
                }
                float[][] cr = k == deepest ? composer.unfollowed(levels[k])
                        : composer.followed(levels[k], levels[k + 1], mirrored.world());
                composer.level(levels[k], shining, layers, null, k == 0 ? scene.world() : mirrored.world(), cr);
            }
            composer.toFilm(levels[0], scene.world(), film.red(tile), film.green(tile), film.blue(tile));
        }

        private HitRows level(int k) {
            if (levels[k] == null) {
                levels[k] = new HitRows(Film.TILE_PIXELS, true);
            }
            return levels[k];
        }

        private void light(HitRows rows, Lamp[] lamps, Progress progress) {
            columns.reset();
            for (int l = 0; l < lamps.length && !progress.isCancelled(); l++) {
                layers[l] = lamps[l].isDark() ? null : lights.full(rows, lamps[l], columns);
            }
        }
    }
}
