package lightning.relight;

import java.util.Arrays;
import java.util.concurrent.CancellationException;
import lightning.cache.CachedTile;
import lightning.cache.LayerStamp;
import lightning.cache.PixelCache;
import lightning.image.Film;
import lightning.scene.Scene;
import lightning.shading.Lamp;
import lightning.shading.Progress;
import lightning.shading.Workers;
import lightning.trace.Geometry;

/**
 * The running renderer: keeps the pixel cache of one picture and brings it to whatever scene is
 * wanted, with the least work. Not for use by two threads at once.
 */
public final class Renderer implements AutoCloseable {
    private final Options options;
    private final Workers workers;
    private final Drag drag = new Drag();
    private final Drag mirroredDrag = new Drag();
    private PixelCache cache;
    private double exposure;

    public Renderer(Options options) {
        this.options = options;
        workers = new Workers(options.threads());
    }

    public Options options() {
        return options;
    }

    /**
     * Tells how the film is shown, which decides when an error of level ratio would become visible.
     *
     * @param stops the exposure, in stops
     */
    public void setExposure(double stops) {
        exposure = stops;
    }

    /** What {@link #render} would do. */
    public UpdatePlan plan(Scene wanted) {
        return Dispatcher.plan(cache, options.view().of(wanted), options.reflections() == Reflections.CURRENT,
                options.accuracy());
    }

    /**
     * Makes the film show the wanted scene.
     *
     * @throws CancellationException if {@code progress} asked to stop; everything
     *         is then as before the call
     */
    public Update render(Scene wanted, Progress progress) {
        return run(plan(wanted), options.view().of(wanted), progress);
    }

    /**
     * Makes the mirror images show the scene rendered last (paper §4.8).
     *
     * @throws IllegalStateException if nothing was rendered yet
     * @throws CancellationException as {@link #render}
     */
    public Update updateReflections(Progress progress) {
        return run(Dispatcher.plan(cache(), cache().scene(), true, options.accuracy()), cache().scene(), progress);
    }

    /** Whether the mirror images show the scene rendered last. */
    public boolean reflectionsAreCurrent() {
        return cache().mirroredScene().equals(cache().scene());
    }

    /** The picture as it is now: later updates make new ones. */
    public Film film() {
        return cache().film();
    }

    /** The scene rendered last, as the view shows it. */
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

    /** Drops all that is known: the next picture is a first pass. */
    public void forget() {
        cache = null;
    }

    private Update run(UpdatePlan plan, Scene wanted, Progress progress) {
        long start = System.nanoTime();
        PixelCache before = cache;
        Work work = switch (plan) {
            case UpdatePlan.Nothing _ -> Work.NONE;
            case UpdatePlan.FirstPass _ -> firstPass(wanted, progress);
            case UpdatePlan.Relight relight -> relight(relight, wanted, progress);
        };
        ErrorBound bound = ErrorBound.of(cache);
        boolean refreshed = bound.shows(exposure);
        if (refreshed) {
            work = work.plus(refresh(before, progress));
            bound = ErrorBound.of(cache);
        }
        return new Update(plan, work.rowsTouched(), work.rowsComposed(), work.bytesMoved(), work.rays(), System.nanoTime() - start,
                bound.largest(), refreshed);
    }

    /** Contributions anew; where this is cancelled, the update that made it necessary is undone too. */
    private Work refresh(PixelCache before, Progress progress) {
        try {
            return relight(Dispatcher.refresh(cache), cache.scene(), progress);
        } catch (CancellationException e) {
            cache = before;
            throw e;
        }
    }

    private Work firstPass(Scene wanted, Progress progress) {
        Geometry geometry = cache != null && cache.geometry().serves(wanted) ? cache.geometry() : new Geometry(wanted);
        Job.Shown shown = Job.Shown.of(geometry, wanted);
        Lamp[] lamps = shown.lamps();
        Job job = new Job(shown, shown, options, null, null, progress);
        LayerStamp[] stamps = new LayerStamp[lamps.length];
        for (int l = 0; l < lamps.length; l++) {
            stamps[l] = lamps[l].isDark() ? null : LayerStamp.fresh(lamps[l].light());
        }
        int tilesY = (wanted.picture().height() + Film.TILE - 1) / Film.TILE;
        CachedTile[] tiles = new CachedTile[job.tilesX() * tilesY];
        TileWorker[] threads = threads(job);
        workers.run(tiles.length, (worker, tile) -> tiles[tile] = threads[worker].firstPass(tile), progress);
        cache = new PixelCache(shown.geometry(), tiles, wanted, wanted, stamps, stamps);
        return Work.of(threads);
    }

    private Work relight(UpdatePlan.Relight plan, Scene wanted, Progress progress) {
        PixelCache old = cache;
        boolean mirrors = plan.mirrors() != null;
        Job.Shown shown = Job.Shown.of(old.geometry(), wanted);
        Job.Shown mirrored = mirrors ? shown : Job.Shown.of(old.geometry(), old.mirroredScene());
        Job job = new Job(shown, mirrored, options, Job.Level.of(plan.top(), old.scene(), shown.lamps(), drag),
                mirrors ? Job.Level.of(plan.mirrors(), old.mirroredScene(), shown.lamps(), mirroredDrag) : null, progress);
        CachedTile[] tiles = new CachedTile[old.tileCount()];
        TileWorker[] threads = threads(job);
        workers.run(tiles.length, (worker, tile) -> tiles[tile] = threads[worker].relight(tile, old.tile(tile)), progress);
        double leastFalloff = 1;
        for (TileWorker thread : threads) {
            leastFalloff = Math.min(leastFalloff, thread.leastFalloff());
        }
        cache = new PixelCache(shown.geometry(), tiles, wanted, mirrors ? wanted : old.mirroredScene(),
                stamps(plan.top(), leastFalloff), mirrors ? stamps(plan.mirrors(), leastFalloff) : old.mirroredStamps());
        return Work.of(threads);
    }

    private TileWorker[] threads(Job job) {
        TileWorker[] threads = new TileWorker[workers.count()];
        Arrays.setAll(threads, _ -> new TileWorker(job));
        return threads;
    }

    private LayerStamp[] stamps(LevelPlan plan, double leastFalloff) {
        boolean scaled = options.accuracy() == Accuracy.RATIO;
        return plan.layers().stream().map(layer -> layer.stamp(scaled, leastFalloff)).toArray(LayerStamp[]::new);
    }

    @Override
    public void close() {
        workers.close();
    }
}
