package lightning.render.relight.tile;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.render.cache.CachedTile;
import lightning.render.cache.FineTile;
import lightning.render.cache.KnownLight;
import lightning.render.cache.LayerStamp;
import lightning.render.cache.PixelCache;
import lightning.render.engine.Crew;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.shading.EdgeCodes;
import lightning.render.shading.EdgeMap;
import lightning.render.shading.Luminaire;
import lightning.render.shading.SeenScenes;
import lightning.scene.Antialias;
import lightning.scene.Light;

/**
 * Builds the pixel cache of a picture on all threads: all of it, the pixels' centres alone, or the finer samples of known centres.
 * One for each job.
 */
public final class CacheBuilder {
    /** Of a small picture each thread takes tiles so many times at least, so that all are ready at about the same time. */
    private static final int EACH = 8;

    private final Job job;
    private final Workers workers;
    private final PixelCache old;
    private final List<Crew<TileWorker>> threads;
    private final int[] order;

    /** @param old the cache to start from, or null for a first pass */
    public CacheBuilder(Job job, Workers workers, PixelCache old) {
        this.job = job;
        this.workers = workers;
        this.old = old;
        threads = Crew.each(workers.count(), job.options().engines(), engine -> new TileWorker(job, engine));
        order = old == null ? MiddleFirst.order(job.tilesX(), job.tileCount()) : IntStream.range(0, job.tileCount()).toArray();
    }

    /** A new cache and the work that it took. */
    public record Built(PixelCache cache, Tally work) {}

    /**
     * Builds the cache as the job plans it.
     *
     * @param centersAlone whether finer samples are left out
     * @throws java.util.concurrent.CancellationException if the job's progress asked to stop
     */
    public Built build(boolean centersAlone) {
        CachedTile[] centers = centers(centersAlone ? 0 : fineTiles());
        FineTile[] fine = centersAlone ? new FineTile[0] : samples(centers, centers.length);
        List<KnownLight> lights = job.plan() == null ? KnownLight.all(job.scene(), this::fresh) : after(job.top());
        List<KnownLight> mirrored = job.plan() == null ? lights : job.mirrors() == null ? old.mirroredLights() : after(job.mirrors());
        return new Built(new PixelCache(job.shown().geometry(), centers, fine, new SeenScenes(job.scene(), job.mirrored().scene()), lights,
                mirrored), work());
    }

    private LayerStamp fresh(Light light) {
        return Luminaire.of(light, job.scene()).isDark() ? null : LayerStamp.fresh(light);
    }

    private List<KnownLight> after(LevelPlan plan) {
        return plan.after(job.options().method(), made().mapToDouble(TileWorker::leastFalloff).reduce(1, Math::min));
    }

    /**
     * Adds the finer samples to known centres.
     *
     * @throws java.util.concurrent.CancellationException if the job's progress asked to stop
     */
    public Built finish(PixelCache centers) {
        return new Built(new PixelCache(centers.geometry(), centers.tiles(), samples(centers.tiles(), 0), centers.scenes(),
                centers.lights(), centers.mirroredLights()), work());
    }

    /**
     * Makes the pixels' centres; none where all pixels have several samples.
     *
     * @param more how many tiles are made afterwards, for who hears of the progress
     */
    private CachedTile[] centers(int more) {
        CachedTile[] tiles = new CachedTile[job.sampling().antialias() == Antialias.EVERY ? 0 : job.tileCount()];
        Progress part = job.progress().part(0, tiles.length + more);
        if (old == null) {
            workers.run(tiles.length, (worker, i) -> first(tiles, worker, order[i]), part);
        } else {
            relight(tiles, part);
        }
        return tiles;
    }

    private void first(CachedTile[] tiles, int worker, int tile) {
        tiles[tile] = threads.get(worker).forTile(tile).firstPass(tile);
        if (tiles[tile] != null) {
            job.progress().made(tile, tiles[tile].film);
        }
    }

    private void relight(CachedTile[] tiles, Progress progress) {
        int together = Math.clamp(tiles.length / (EACH * workers.count()), 1, Approach.TILES);
        CachedTile[] known = old.tiles();
        Approach[] approach = new Approach[workers.count()];
        Arrays.setAll(approach, worker -> new Approach());
        workers.run(tiles.length, together, (worker, tile) -> {
            if (tile % together == 0) {
                approach[worker].to(known, tile, Math.min(tiles.length, tile + together));
            }
            tiles[tile] = threads.get(worker).forTile(tile).relight(tile, known[tile]);
        }, progress);
    }

    /** How many tiles of finer samples the picture has: none without anti-aliasing. */
    private int fineTiles() {
        return job.sampling().isFine() ? job.tileCount() : 0;
    }

    /**
     * Makes the finer samples of each tile.
     *
     * @param centers the pixels' centres as they are now; none where all pixels have several samples
     * @param before  how many tiles were made before, for who hears of the progress
     */
    private FineTile[] samples(CachedTile[] centers, int before) {
        FineTile[] fine = new FineTile[fineTiles()];
        if (fine.length == 0) {
            return fine;
        }
        boolean known = old != null && old.scene().picture().sampling().samplesLike(job.sampling());
        EdgeMap edges = edges(centers);
        EdgeMap edgesBefore = known ? edges(old.tiles()) : null;
        FineWorker[] finer = new FineWorker[threads.size()];
        Arrays.setAll(finer, worker -> new FineWorker(job, threads.get(worker), edges, edgesBefore));
        workers.run(fine.length, (worker, i) -> {
            int tile = order[i];
            fine[tile] = finer[worker].tile(tile, centers.length == 0 ? null : centers[tile],
                    !known || centers.length == 0 ? null : old.tile(tile), known ? old.fine(tile) : null);
            if (old == null && fine[tile] != null) {
                job.progress().made(tile, fine[tile].film());
            }
        }, job.progress().part(before, before + fine.length));
        return fine;
    }

    private EdgeMap edges(CachedTile[] centers) {
        EdgeCodes[] codes = Arrays.stream(centers).map(tile -> tile.codes).toArray(EdgeCodes[]::new);
        return new EdgeMap(job.scene().picture().width(), job.scene().picture().height(), codes);
    }

    private Stream<TileWorker> made() {
        return threads.stream().flatMap(crew -> crew.all().stream());
    }

    private Tally work() {
        return made().map(TileWorker::work).reduce(Tally.NONE, Tally::plus);
    }
}
