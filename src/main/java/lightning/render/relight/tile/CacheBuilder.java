package lightning.render.relight.tile;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.cache.CachedLight;
import lightning.render.cache.CachedScene;
import lightning.render.cache.CachedTile;
import lightning.render.cache.FineTile;
import lightning.render.cache.IndirectCache;
import lightning.render.cache.PixelCache;
import lightning.render.engine.EngineWorkers;
import lightning.render.gather.PointChanges;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.shading.EdgeColors;
import lightning.render.shading.composition.EdgeDetector;
import lightning.render.shading.fog.PictureFog;
import lightning.scene.AntialiasMode;
import org.jspecify.annotations.Nullable;

/**
 * Builds the pixel cache of a picture on all threads: the whole cache, only pixel centers, or the finer samples of existing centers.
 */
public final class CacheBuilder {
    /** With its indirect light, which is computed first. */
    private final RenderJob job;
    private final WorkerPool workers;
    private final @Nullable PixelCache oldCache;
    private final List<EngineWorkers<TileWorker>> tileWorkers;
    private final int[] tileOrder;
    /** Rays that each thread reported. */
    private final long[] reportedRays;

    private CacheBuilder(RenderJob job, WorkerPool workers, @Nullable PixelCache old) {
        this.job = job;
        this.workers = workers;
        this.oldCache = old;
        tileWorkers = EngineWorkers.perThread(workers.count(), job.options().engines(), engine -> new TileWorker(job, engine));
        reportedRays = new long[workers.count()];
        tileOrder = old == null ? CenterFirstOrder.tileOrder(job.tilesX(), job.tileCount()) : IntStream.range(0, job.tileCount()).toArray();
    }

    /** New cache and the work it took. */
    public record BuildResult(PixelCache cache, WorkCounts work) {}

    /**
     * Builds a cache as a job plans it: indirect light, fog, then tiles.
     *
     * @param planned     job without indirect light
     * @param old         the cache to start from, or null for a first pass
     * @param centersOnly true if finer samples are left out
     * @throws java.util.concurrent.CancellationException if the job's progress requested cancellation
     */
    public static BuildResult build(RenderJob planned, WorkerPool workers, @Nullable PixelCache old, boolean centersOnly) {
        IndirectBuilder indirectBuilder = new IndirectBuilder(planned, workers, old);
        IndirectCache indirect = indirectBuilder.build();
        IndirectCache mirroredIndirect = planned.mirrorTarget() == planned.target() ? indirect : requireNonNull(old).mirrored().indirect();
        RenderJob job = planned.withIndirect(indirect, mirroredIndirect, old, indirectBuilder.pointChanges())
                .withProgress(indirectBuilder.tileProgress());
        FogUpdate fog = new FogUpdate(job, workers, old);
        job = fog.apply().compare(old);
        BuildResult tiles = new CacheBuilder(job, workers, old).buildTiles(indirect, mirroredIndirect, centersOnly);
        return new BuildResult(tiles.cache(), tiles.work().plus(indirectBuilder.work()).plus(fog.work()));
    }

    /**
     * Adds the finer samples to existing centers.
     *
     * @param planned job without indirect light
     * @param old     the cache to start from
     * @throws java.util.concurrent.CancellationException if the job's progress requested cancellation
     */
    public static BuildResult finish(RenderJob planned, WorkerPool workers, @Nullable PixelCache old, PixelCache centers) {
        PictureFog bounced = centers.mirrored().fog();
        RenderJob job = planned.withIndirect(centers.indirect(), centers.mirrored().indirect(), old, pointChanges(old, centers))
                .withFog(centers.shown().fog())
                .withBounceFog(bounced)
                .withChangesBounceFog(FogUpdate.showsOtherLight(old == null ? null : old.mirrored().fog(), bounced)).compare(old);
        return new CacheBuilder(job, workers, old).addSamples(centers);
    }

    /** Returns the change of the gather points since an older picture; null if all may have changed, or none did. */
    private static @Nullable PointChanges pointChanges(@Nullable PixelCache old, PixelCache centers) {
        IndirectCache before = old == null ? null : old.indirect();
        IndirectCache after = centers.indirect();
        return before == null || after == null || before.structure() == after.structure() || !before.settings().equals(after.settings())
                ? null
                : PointChanges.between(before.structure(), after.structure());
    }

    private BuildResult buildTiles(@Nullable IndirectCache indirect, @Nullable IndirectCache mirroredIndirect, boolean centersOnly) {
        CachedTile[] centers = buildCenters(centersOnly ? 0 : fineTileCount());
        FineTile[] fine = centersOnly ? new FineTile[0] : buildSamples(centers, centers.length);
        List<CachedLight> lights = job.plan() == null ? CachedLight.ofScene(job.scene()) : lightsAfter(job.topPlan());
        List<CachedLight> mirrored =
                job.plan() == null ? lights : job.mirrorPlan() == null ? requireNonNull(oldCache).mirrored().lights()
                        : lightsAfter(job.mirrorPlan());
        return new BuildResult(
                new PixelCache(job.target().geometry(), centers, fine, new CachedScene(job.scene(), lights, indirect, job.fog()),
                        new CachedScene(job.mirroredScene(), mirrored, mirroredIndirect, job.bounceFog()),
                        !job.options().method().isExact()),
                work());
    }

    private List<CachedLight> lightsAfter(@Nullable LevelPlan plan) {
        return requireNonNull(plan).lightsAfter(job.options().method(),
                allWorkers().mapToDouble(TileWorker::minFalloff).reduce(1, Math::min));
    }

    private BuildResult addSamples(PixelCache centers) {
        return new BuildResult(centers.withFineTiles(buildSamples(centers.tiles(), 0)), work());
    }

    /**
     * Builds the pixel centers; none if all pixels have several samples.
     *
     * @param laterTiles number of tiles built afterwards, for progress reports
     */
    private CachedTile[] buildCenters(int laterTiles) {
        CachedTile[] tiles = new CachedTile[job.sampling().antialias() == AntialiasMode.EVERY ? 0 : job.tileCount()];
        Progress part = job.progress().subProgress(0, tiles.length + laterTiles);
        if (oldCache == null) {
            workers.run(tiles.length, (worker, i) -> buildTile(tiles, worker, tileOrder[i]), part);
        } else {
            relightTiles(tiles, part);
        }
        return tiles;
    }

    private void buildTile(CachedTile[] tiles, int worker, int tile) {
        tiles[tile] = tileWorkers.get(worker).forTile(tile).firstPass(tile);
        reportTile(worker, tile, tiles[tile] == null ? null : tiles[tile].film());
    }

    /** @param film colors of the tile; null if it was canceled */
    private void reportTile(int worker, int tile, float @Nullable [][] film) {
        long rays = 0;
        for (TileWorker engineWorker : tileWorkers.get(worker).workers()) {
            rays += engineWorker.rayCount();
        }
        if (rays > reportedRays[worker]) {
            job.progress().raysCast(rays - reportedRays[worker]);
            reportedRays[worker] = rays;
        }
        if (film != null) {
            job.progress().tileFinished(tile, film);
        }
    }

    private void relightTiles(CachedTile[] tiles, Progress progress) {
        CachedTile[] known = requireNonNull(oldCache).tiles();
        workers.run(tiles.length, (worker, tile) -> {
            tiles[tile] = tileWorkers.get(worker).forTile(tile).relight(tile, known[tile]);
            reportTile(worker, tile, tiles[tile] == null ? null : tiles[tile].film());
        }, progress);
    }

    /** Returns the number of tiles with finer samples: 0 without anti-aliasing. */
    private int fineTileCount() {
        return job.sampling().isSupersampled() ? job.tileCount() : 0;
    }

    /**
     * Builds the finer samples of each tile.
     *
     * @param centers the current pixel centers; none if all pixels have several samples
     * @param before  number of tiles built before, for progress reports
     */
    private FineTile[] buildSamples(CachedTile[] centers, int before) {
        FineTile[] fine = new FineTile[fineTileCount()];
        if (fine.length == 0) {
            return fine;
        }
        PixelCache known = oldCache != null && oldCache.scene().hasSameSamples(job.scene()) ? oldCache : null;
        EdgeDetector edges = edgeDetector(centers);
        EdgeDetector edgesBefore = known == null ? null : edgeDetector(known.tiles());
        FineSampleWorker[] sampleWorkers = new FineSampleWorker[tileWorkers.size()];
        Arrays.setAll(sampleWorkers, worker -> new FineSampleWorker(job, tileWorkers.get(worker), edges, edgesBefore));
        workers.run(fine.length, (worker, i) -> {
            int tile = tileOrder[i];
            fine[tile] = sampleWorkers[worker].buildTile(tile, centers.length == 0 ? null : centers[tile],
                    known == null || centers.length == 0 ? null : known.tile(tile), known == null ? null : known.fineTile(tile));
            reportTile(worker, tile, fine[tile] == null ? null : fine[tile].film());
        }, job.progress().subProgress(before, before + fine.length));
        return fine;
    }

    private EdgeDetector edgeDetector(CachedTile[] centers) {
        EdgeColors[] colors = Arrays.stream(centers).map(tile -> tile.edges()).toArray(EdgeColors[]::new);
        return new EdgeDetector(job.scene().picture().width(), job.scene().picture().height(), colors);
    }

    private Stream<TileWorker> allWorkers() {
        return tileWorkers.stream().flatMap(thread -> thread.workers().stream());
    }

    private WorkCounts work() {
        return allWorkers().map(TileWorker::work).reduce(WorkCounts.NONE, WorkCounts::plus);
    }
}
