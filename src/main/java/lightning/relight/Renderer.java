package lightning.relight;

import java.util.Arrays;
import lightning.cache.CachedTile;
import lightning.cache.PixelCache;
import lightning.image.Film;
import lightning.scene.Light;
import lightning.scene.Scene;
import lightning.shading.Lamp;
import lightning.shading.Progress;
import lightning.shading.TraceCounts;
import lightning.shading.Workers;
import lightning.trace.Geometry;

/**
 * The running renderer: keeps the pixel cache of one picture and brings it to whatever scene is
 * wanted, with the least work. Not for use by two threads at once.
 */
public final class Renderer implements AutoCloseable {
    private final Options options;
    private final Workers workers;
    private PixelCache cache;

    public Renderer(Options options) {
        this.options = options;
        workers = new Workers(options.threads());
    }

    public Options options() {
        return options;
    }

    /** What {@link #render} would do. */
    public UpdatePlan plan(Scene wanted) {
        return Dispatcher.plan(cache, wanted, options.reflections() == Reflections.CURRENT);
    }

    /**
     * Makes the film show the wanted scene.
     *
     * @throws java.util.concurrent.CancellationException if {@code progress} asked to stop; everything
     *         is then as before the call
     */
    public Update render(Scene wanted, Progress progress) {
        return run(plan(wanted), wanted, progress);
    }

    /**
     * Makes the mirror images show the scene rendered last (paper §4.8).
     *
     * @throws IllegalStateException if nothing was rendered yet
     * @throws java.util.concurrent.CancellationException as {@link #render}
     */
    public Update updateReflections(Progress progress) {
        return run(Dispatcher.plan(cache(), cache().scene(), true), cache().scene(), progress);
    }

    /** Whether the mirror images show the scene rendered last. */
    public boolean reflectionsAreCurrent() {
        return cache().mirroredScene().equals(cache().scene());
    }

    /** The picture, valid until the second next update. */
    public Film film() {
        return cache().film();
    }

    /** The scene rendered last. */
    public Scene scene() {
        return cache().scene();
    }

    /**
     * What is kept of the picture.
     *
     * @throws IllegalStateException if nothing was rendered yet
     */
    public PixelCache cache() {
        if (cache == null) {
            throw new IllegalStateException("nothing was rendered yet");
        }
        return cache;
    }

    private Update run(UpdatePlan plan, Scene wanted, Progress progress) {
        long start = System.nanoTime();
        return switch (plan) {
            case UpdatePlan.Nothing _ ->
                new Update(plan, 0, 0, TraceCounts.NONE, System.nanoTime() - start, 0, false);
            case UpdatePlan.FirstPass _ -> firstPass(plan, wanted, progress, start);
            case UpdatePlan.Relight relight -> relight(relight, wanted, progress, start);
        };
    }

    private boolean keepsRows() {
        return options.storage() == MirrorStorage.FULL_ROWS;
    }

    private Update firstPass(UpdatePlan plan, Scene wanted, Progress progress, long start) {
        Geometry geometry = cache != null && cache.geometry().serves(wanted) ? cache.geometry() : new Geometry(wanted);
        Lamp[] lamps = Job.lamps(wanted);
        Job job = new Job(geometry, wanted, lamps, keepsRows(), null, null, progress);
        Light[] stamps = new Light[lamps.length];
        for (int l = 0; l < lamps.length; l++) {
            stamps[l] = lamps[l].isDark() ? null : lamps[l].light();
        }
        int tilesY = (wanted.picture().height() + Film.TILE - 1) / Film.TILE;
        CachedTile[] tiles = new CachedTile[job.tilesX() * tilesY];
        TileWorker[] threads = threads(job);
        workers.run(tiles.length, (worker, tile) -> tiles[tile] = threads[worker].firstPass(tile), progress);
        cache = new PixelCache(geometry, tiles, wanted, wanted, stamps, stamps);
        return update(plan, threads, start);
    }

    private Update relight(UpdatePlan.Relight plan, Scene wanted, Progress progress, long start) {
        PixelCache old = cache;
        Lamp[] lamps = Job.lamps(wanted);
        Job job = new Job(old.geometry(), wanted, lamps, keepsRows(),
                Job.Level.of(plan.top(), old.scene(), lamps),
                plan.mirrors() == null ? null : Job.Level.of(plan.mirrors(), old.mirroredScene(), lamps), progress);
        CachedTile[] tiles = new CachedTile[old.tileCount()];
        TileWorker[] threads = threads(job);
        workers.run(tiles.length, (worker, tile) -> tiles[tile] = threads[worker].relight(old.tile(tile)), progress);
        boolean mirrors = plan.mirrors() != null;
        cache = new PixelCache(old.geometry(), tiles, wanted, mirrors ? wanted : old.mirroredScene(), stamps(plan.top()),
                mirrors ? stamps(plan.mirrors()) : stamps(old));
        return update(plan, threads, start);
    }

    private TileWorker[] threads(Job job) {
        TileWorker[] threads = new TileWorker[workers.count()];
        Arrays.setAll(threads, _ -> new TileWorker(job));
        return threads;
    }

    private static Light[] stamps(LevelPlan plan) {
        return plan.layers().stream().map(LayerPlan::stamp).toArray(Light[]::new);
    }

    private static Light[] stamps(PixelCache old) {
        Light[] stamps = new Light[old.mirroredScene().lights().size()];
        Arrays.setAll(stamps, old::mirroredStamp);
        return stamps;
    }

    private static Update update(UpdatePlan plan, TileWorker[] threads, long start) {
        TraceCounts rays = TraceCounts.NONE;
        long touched = 0;
        long composed = 0;
        for (TileWorker thread : threads) {
            rays = rays.plus(thread.rays());
            touched += thread.rowsTouched();
            composed += thread.rowsComposed();
        }
        return new Update(plan, touched, composed, rays, System.nanoTime() - start, 0, false);
    }

    @Override
    public void close() {
        workers.close();
    }
}
