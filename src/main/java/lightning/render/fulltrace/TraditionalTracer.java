package lightning.render.fulltrace;

import java.util.List;
import java.util.stream.IntStream;
import lightning.base.work.Progress;
import lightning.base.work.ProgressPart;
import lightning.base.work.WorkerPool;
import lightning.render.engine.EngineChoice;
import lightning.render.engine.EngineWorkers;
import lightning.render.engine.choice.Engines;
import lightning.render.image.Film;
import lightning.render.shading.EdgeColors;
import lightning.render.shading.FilmParts;
import lightning.render.shading.IndirectLight;
import lightning.render.shading.RayCounts;
import lightning.render.shading.RenderedScenes;
import lightning.render.shading.composition.EdgeDetector;
import lightning.render.shading.fog.PictureFog;
import lightning.render.trace.Geometry;
import lightning.scene.GatherSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Fastest full tracer without a cache, tile by tile: the baseline of all measured savings. */
public final class TraditionalTracer {
    /** Usual share of indirect light in the time of a trace. */
    private static final double INDIRECT_SHARE = 0.6;
    /** Usual share of fog in the time after that. */
    private static final double FOG_SHARE = 0.5;

    private final Geometry geometry;
    private final Geometry mirroredGeometry;
    private final Scene scene;
    private final Scene mirrored;
    private final SamplingSettings sampling;
    private final EngineChoice engines;

    /** Prepares a trace and builds the BVH. */
    public TraditionalTracer(Scene scene) {
        this(scene, Geometry.of(scene));
    }

    /**
     * Prepares a trace with existing geometry.
     *
     * @throws IllegalArgumentException if it does not serve the scene
     */
    public TraditionalTracer(Scene scene, Geometry geometry) {
        this(scene, scene, geometry);
    }

    /**
     * Prepares a trace of {@code scene} whose mirrors show {@code mirrored}: the reference for outdated reflections (paper §4.8).
     * The two may differ in lights, world and materials.
     *
     * @throws IllegalArgumentException if the geometry does not serve both
     */
    public TraditionalTracer(Scene scene, Scene mirrored, Geometry geometry) {
        this(scene, mirrored, geometry, Engines.CURRENT);
    }

    private TraditionalTracer(Scene scene, Scene mirrored, Geometry geometry, EngineChoice engines) {
        this.engines = engines;
        this.scene = scene;
        this.mirrored = mirrored;
        sampling = scene.picture().sampling();
        this.geometry = geometry.withMaterialsOf(scene);
        mirroredGeometry = geometry.withMaterialsOf(mirrored);
    }

    /** Returns the same trace with other engines. */
    public TraditionalTracer withEngines(EngineChoice choice) {
        return new TraditionalTracer(scene, mirrored, geometry, choice);
    }

    /** Finished picture and its ray counts. */
    public record Result(Film film, RayCounts rays) {}

    /**
     * Traces the whole picture.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} requested cancellation
     */
    public Result trace(WorkerPool workers, Progress progress) {
        return trace(workers, allTiles(), progress);
    }

    /**
     * Traces the indirect light of the scene alone; returns null if it has none.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} requested cancellation
     */
    public @Nullable IndirectLight traceIndirect(WorkerPool workers, Progress progress) {
        return new IndirectTracer(geometry, FilmParts.of(scene), engines, workers, progress).trace();
    }

    /**
     * Traces the fog of the picture alone; returns null if its air is clear.
     *
     * @throws java.util.concurrent.CancellationException if the progress requested cancellation
     */
    public @Nullable PictureFog traceFog(WorkerPool workers, Progress progress) {
        return new FogTracer(geometry, scene, engines, workers, new ProgressPart(progress, 0, 1)).trace(FilmParts.of(scene).lights());
    }

    /**
     * Traces the fog along bounced rays alone, of the scene that mirrors show; returns null if no light is seen there.
     *
     * @throws java.util.concurrent.CancellationException if the progress requested cancellation
     */
    public @Nullable PictureFog traceBounceFog(WorkerPool workers, Progress progress) {
        return new FogTracer(mirroredGeometry, mirrored, engines, workers, new ProgressPart(progress, 0, 1))
                .traceBounces(FilmParts.of(mirrored).lights());
    }

    private int[] allTiles() {
        int tilesPerRow = Film.tilesAlong(scene.picture().width());
        int tileRows = Film.tilesAlong(scene.picture().height());
        return IntStream.range(0, tilesPerRow * tileRows).toArray();
    }

    /**
     * Traces some tiles; the others stay black.
     *
     * @param tiles numbers of the film's tiles to trace
     * @throws java.util.concurrent.CancellationException if {@code progress} requested cancellation
     */
    public Result trace(WorkerPool workers, int[] tiles, Progress progress) {
        if (GatherSettings.of(scene).isEmpty() && GatherSettings.of(mirrored).isEmpty()) {
            return trace(workers, tiles, progress, progress);
        }
        return trace(workers, tiles, new ProgressPart(progress, 0, INDIRECT_SHARE), new ProgressPart(progress, INDIRECT_SHARE, 1));
    }

    /**
     * Traces some tiles without gathered light, blurred reflections and fog, whose cost depends little on the size of the picture.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} requested cancellation
     */
    public Film traceDirectLight(WorkerPool workers, int[] tiles, Progress progress) {
        RenderedScenes scenes = new RenderedScenes(scene, mirrored);
        return trace(workers, createTracers(workers, scenes, TileTracer.SceneLights.of(scenes)), tiles, progress);
    }

    private Result trace(WorkerPool workers, int[] tiles, Progress indirectProgress, Progress progress) {
        RenderedScenes scenes = new RenderedScenes(scene, mirrored);
        TileTracer.SceneLights lights = TileTracer.SceneLights.of(scenes);
        IndirectTracer indirect = new IndirectTracer(geometry, lights.direct(), engines, workers, indirectProgress);
        IndirectTracer inMirrors = !lights.areMirrorsOutdated() ? indirect
                : new IndirectTracer(mirroredGeometry, lights.mirrored(), engines, workers, indirectProgress);
        IndirectLight light = indirect.trace();
        ProgressPart fogProgress = new ProgressPart(progress, 0, FOG_SHARE);
        FogTracer fog = new FogTracer(geometry, scene, engines, workers, fogProgress.section(0, 2));
        FogTracer mirroredFog = new FogTracer(mirroredGeometry, mirrored, engines, workers, fogProgress.section(1, 2));
        List<EngineWorkers<TileTracer>> threads =
                createTracers(workers, scenes, lights.withIndirect(light, inMirrors == indirect ? light : inMirrors.trace())
                        .withFog(fog.trace(lights.direct().lights()), mirroredFog.traceBounces(lights.mirrored().lights())));
        Film film = trace(workers, threads, tiles,
                scene.world().fog().isPresent() ? new ProgressPart(progress, FOG_SHARE, 1) : progress);
        RayCounts rays = indirect.rays().plus(inMirrors == indirect ? RayCounts.NONE : inMirrors.rays());
        rays = rays.plus(fog.rays()).plus(mirroredFog.rays());
        for (EngineWorkers<TileTracer> thread : threads) {
            for (TileTracer tracer : thread.workers()) {
                rays = rays.plus(tracer.rays());
            }
        }
        return new Result(film, rays);
    }

    private Film trace(WorkerPool workers, List<EngineWorkers<TileTracer>> threads, int[] tiles, Progress progress) {
        Film film = Film.black(scene.picture().width(), scene.picture().height());
        if (scene.hasSamplesOnlyAtEdges()) {
            traceEdges(film, workers, threads, tiles, progress);
        } else if (sampling.isSupersampled()) {
            workers.run(tiles.length, (worker, i) -> threads.get(worker).forTile(tiles[i]).traceSamples(film, tiles[i],
                    EdgeDetector.allPixels(film.width(), film.height(), tiles[i]), progress), progress);
        } else {
            workers.run(tiles.length, (worker, i) -> threads.get(worker).forTile(tiles[i]).traceCenters(film, tiles[i], progress),
                    progress);
        }
        return film;
    }

    /** Traces all centers first, those of neighboring tiles too, to find edges; then traces the pixels on an edge with all samples. */
    private void traceEdges(Film film, WorkerPool workers, List<EngineWorkers<TileTracer>> threads, int[] tiles, Progress progress) {
        int[] edgeTiles = EdgeDetector.addNeighborTiles(film, tiles);
        boolean[] target = new boolean[film.tileCount()];
        for (int tile : tiles) {
            target[tile] = true;
        }
        EdgeColors[] colors = new EdgeColors[film.tileCount()];
        // Tiles that are traced only for their colors go to a scratch film.
        Film scratchFilm = edgeTiles.length == tiles.length ? film : Film.black(film.width(), film.height());
        workers.run(edgeTiles.length, (worker, i) -> {
            int tile = edgeTiles[i];
            colors[tile] = threads.get(worker).forTile(tile).traceCentersWithEdges(target[tile] ? film : scratchFilm, tile, progress);
        }, progress.subProgress(0, edgeTiles.length + tiles.length));
        EdgeDetector map = new EdgeDetector(film.width(), film.height(), colors);
        workers.run(tiles.length,
                (worker, i) -> threads.get(worker).forTile(tiles[i]).traceSamples(film, tiles[i], map.edges(tiles[i]), progress),
                progress.subProgress(edgeTiles.length, edgeTiles.length + tiles.length));
    }

    private List<EngineWorkers<TileTracer>> createTracers(WorkerPool workers, RenderedScenes scenes, TileTracer.SceneLights lights) {
        return EngineWorkers.perThread(workers.count(), engines,
                engine -> new TileTracer(geometry, mirroredGeometry, scenes, lights, sampling, engine));
    }
}
