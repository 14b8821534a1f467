package lightning.render.fulltrace;

import java.util.List;
import java.util.stream.IntStream;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.render.engine.Crew;
import lightning.render.engine.EngineChoice;
import lightning.render.engine.choice.Engines;
import lightning.render.image.Film;
import lightning.render.shading.EdgeCodes;
import lightning.render.shading.EdgeMap;
import lightning.render.shading.SeenScenes;
import lightning.render.shading.TraceCounts;
import lightning.render.trace.Geometry;
import lightning.scene.Sampling;
import lightning.scene.Scene;

/**
 * The yardstick of every saving: a full trace by the fastest code there is, tile by tile, which keeps
 * nothing but the film.
 */
public final class TraditionalTracer {
    private final Geometry geometry;
    private final Geometry mirroredGeometry;
    private final Scene scene;
    private final Scene mirrored;
    private final Sampling sampling;
    private final EngineChoice engines;

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
        this(scene, mirrored, geometry, Engines.OF_PROCESS);
    }

    private TraditionalTracer(Scene scene, Scene mirrored, Geometry geometry, EngineChoice engines) {
        this.engines = engines;
        this.scene = scene;
        this.mirrored = mirrored;
        sampling = scene.picture().sampling();
        this.geometry = geometry.of(scene);
        mirroredGeometry = geometry.of(mirrored);
    }

    /** The same trace by engines of one's choice. */
    public TraditionalTracer by(EngineChoice choice) {
        return new TraditionalTracer(scene, mirrored, geometry, choice);
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
        int across = Film.tilesAlong(scene.picture().width());
        int down = Film.tilesAlong(scene.picture().height());
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
        List<Crew<TileTracer>> threads = threads(workers);
        switch (sampling.antialias()) {
            case OFF -> workers.run(tiles.length, (worker, i) -> threads.get(worker).forTile(tiles[i]).centers(film, tiles[i], progress),
                    progress);
            case EVERY -> workers.run(tiles.length,
                    (worker, i) -> threads.get(worker).forTile(tiles[i]).fine(film, tiles[i],
                            EdgeMap.all(film.width(), film.height(), tiles[i]), progress),
                    progress);
            case EDGES -> edges(film, workers, threads, tiles, progress);
        }
        TraceCounts rays = TraceCounts.NONE;
        for (Crew<TileTracer> thread : threads) {
            for (TileTracer tracer : thread.all()) {
                rays = rays.plus(tracer.rays());
            }
        }
        return new Result(film, rays);
    }

    /** First all centres, the neighbours' too, for the edges between them; then the pixels on an edge again, finer. */
    private void edges(Film film, Workers workers, List<Crew<TileTracer>> threads, int[] tiles, Progress progress) {
        int[] seen = EdgeMap.withNeighbours(film, tiles);
        boolean[] wanted = new boolean[film.tileCount()];
        for (int tile : tiles) {
            wanted[tile] = true;
        }
        EdgeCodes[] codes = new EdgeCodes[film.tileCount()];
        // What is traced for its codes alone goes to a film that nobody sees.
        Film beside = seen.length == tiles.length ? film : Film.black(film.width(), film.height());
        workers.run(seen.length, (worker, i) -> {
            int tile = seen[i];
            codes[tile] = threads.get(worker).forTile(tile).coded(wanted[tile] ? film : beside, tile, progress);
        }, progress.part(0, seen.length + tiles.length));
        EdgeMap map = new EdgeMap(film.width(), film.height(), codes);
        workers.run(tiles.length, (worker, i) -> threads.get(worker).forTile(tiles[i]).fine(film, tiles[i], map.edges(tiles[i]), progress),
                progress.part(seen.length, seen.length + tiles.length));
    }

    private List<Crew<TileTracer>> threads(Workers workers) {
        SeenScenes scenes = new SeenScenes(scene, mirrored);
        return Crew.each(workers.count(), engines, engine -> new TileTracer(geometry, mirroredGeometry, scenes, sampling, engine));
    }
}
