package lightning.render.relight;

import java.util.concurrent.CancellationException;
import java.util.function.Supplier;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.cache.PixelCache;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Film;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.Dispatcher;
import lightning.render.relight.plan.ReflectionMode;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.CacheBuilder;
import lightning.render.relight.tile.RenderJob;
import lightning.render.relight.tile.RenderOptions;
import lightning.render.relight.tile.RepeatedEditDetector;
import lightning.render.relight.tile.WorkCounts;
import lightning.render.shading.RenderedScenes;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;

/**
 * The running renderer: keeps the pixel cache of one picture and brings it to whatever scene is
 * wanted, with the least work. Not for use by two threads at once.
 */
public final class Renderer implements AutoCloseable {
    private RenderOptions options;
    private WorkerPool workers;
    private final RepeatedEditDetector.LevelDetectors repeatedEdits = new RepeatedEditDetector.LevelDetectors();
    private PixelCache cache;
    /** What the cache lacks, where it holds pixels' centers alone; else null. */
    private PendingSamples pendingSamples;
    private final GeometrySource geometrySource = new GeometrySource();
    /** How the cache is known; its accuracy differs from the wanted one after a change, until the next update. */
    private Accuracy cacheAccuracy;
    private double exposure;
    private DisplayCurve curve = DisplayCurve.SRGB;

    public Renderer(RenderOptions options) {
        this.options = options;
        workers = new WorkerPool(options.threads());
    }

    public RenderOptions options() {
        return options;
    }

    /**
     * Tells how the film is shown, which decides when an error of accuracy ratio would become visible.
     *
     * @param stops the exposure, in stops
     */
    public void setView(double stops, DisplayCurve displayCurve) {
        exposure = stops;
        curve = displayCurve;
    }

    /**
     * Goes on in another way of working. What is known is kept, and brought to another accuracy by the next update, without
     * a ray; only another view, or another storage of mirror levels, forgets it.
     */
    public void setOptions(RenderOptions to) {
        if (pendingSamples != null && (to.accuracy() != options.accuracy() || to.reflections() != options.reflections())) {
            // Samples could not follow centers that are known in another way.
            restore(pendingSamples.finishedCache());
        }
        if (to.threads() != options.threads()) {
            workers.close();
            workers = new WorkerPool(to.threads());
        }
        boolean canReuse = to.view().hasSameTrace(options.view()) && to.storage() == options.storage()
                && (to.accuracy() == cacheAccuracy || cache == null || CacheConversion.canConvert(cache));
        options = to;
        if (!canReuse) {
            clear();
        }
    }

    /** What it takes to make the film show the wanted scene. */
    public PlannedUpdate plan(Scene target) {
        return plan(options.view().apply(target), options.reflections() == ReflectionMode.CURRENT);
    }

    private PlannedUpdate plan(Scene target, boolean mirrors) {
        long start = System.nanoTime();
        PendingSamples.Start base = pendingSamples == null ? new PendingSamples.Start(cache, difference(target, mirrors))
                : pendingSamples.chooseStart(cache, target, mirrors);
        UpdatePlan reported =
                base.plan() instanceof UpdatePlan.Nothing && needsConversion() ? new CacheConversion(cache, options).plan() : base.plan();
        return new PlannedUpdate(target, mirrors, base.plan(), reported, base.from(), cache, System.nanoTime() - start);
    }

    private UpdatePlan difference(Scene target, boolean mirrors) {
        return Dispatcher.plan(cache, target, mirrors, options.method());
    }

    private boolean needsConversion() {
        return cache != null && cacheAccuracy != options.accuracy();
    }

    /**
     * Makes the film show the wanted scene. Whatever is thrown, an {@link OutOfMemoryError} included, everything is then as before the
     * call.
     *
     * @throws PictureTooLargeException if it needs a first pass that does not fit into memory beside what is known of the picture, which a
     *                         canceled pass goes back to
     * @throws CancellationException if {@code progress} asked to stop
     */
    public UpdateResult render(Scene target, Progress progress) {
        return render(plan(target), progress);
    }

    /**
     * The same; where a first pass does not fit beside what is known of the picture, it begins without that.
     *
     * @throws PictureTooLargeException       if it does not fit even so; nothing is known then
     * @throws CancellationException likewise
     */
    public UpdateResult renderOrClear(Scene target, Progress progress) {
        try {
            return render(target, progress);
        } catch (PictureTooLargeException e) {
            if (!hasPicture()) {
                throw e;
            }
            clear();
            return render(target, progress);
        }
    }

    /**
     * Does what was planned; where something else is known of the picture since, it is planned anew.
     *
     * @param planned by {@link #plan}
     * @throws PictureTooLargeException       as {@link #render(Scene, Progress)}
     * @throws CancellationException likewise
     */
    public UpdateResult render(PlannedUpdate planned, Progress progress) {
        return runOrRestore(() -> update(replanIfStale(planned), false, progress));
    }

    /**
     * Does what was planned, and leaves it to {@link #finish} to make the finer samples where only edges have them: the film then
     * shows the pixels' centers, as if there were no anti-aliasing. Updates go on from there, whether it was finished or not.
     *
     * @param planned by {@link #plan}
     * @throws PictureTooLargeException       as {@link #render(Scene, Progress)}
     * @throws CancellationException likewise
     */
    public UpdateResult renderCenters(PlannedUpdate planned, Progress progress) {
        return runOrRestore(() -> update(replanIfStale(planned), true, progress));
    }

    /** Whether the film has all samples that its scene asks for. */
    public boolean isFinished() {
        return pendingSamples == null;
    }

    /**
     * Makes the finer samples that {@link #renderCenters} left out.
     *
     * @return all that was done since the last picture that had its samples; where none had them yet, since the newest edit
     * @throws IllegalStateException if the picture is finished
     * @throws CancellationException if {@code progress} asked to stop; everything is then as before the call
     */
    public UpdateResult finish(Progress progress) {
        if (pendingSamples == null) {
            throw new IllegalStateException("the picture is already finished");
        }
        long start = System.nanoTime();
        PendingSamples pending = pendingSamples;
        UpdatePlan plan = pending.plan(cache);
        WorkCounts work = pending.deferredWork().plus(renderSamples(plan, progress));
        return new UpdateResult(plan, work.rowsTouched(), work.rowsComposed(), work.bytesMoved(), work.rays(),
                pending.nanoseconds() + System.nanoTime() - start, 0, false);
    }

    private PlannedUpdate replanIfStale(PlannedUpdate planned) {
        return planned.isPlannedFor(cache) ? planned : plan(planned.target, planned.updatesMirrors);
    }

    /** Goes back to what is known now if the work does not end, for whatever reason. */
    private UpdateResult runOrRestore(Supplier<UpdateResult> work) {
        PixelCache before = cache;
        PendingSamples unfinishedBefore = pendingSamples;
        Accuracy knownBefore = cacheAccuracy;
        UpdateResult update = null;
        try {
            update = work.get();
            return update;
        } finally {
            if (update == null) {
                cache = before;
                pendingSamples = unfinishedBefore;
                cacheAccuracy = knownBefore;
            }
        }
    }

    /**
     * Makes the mirror images show the scene rendered last (paper §4.8).
     *
     * @throws IllegalStateException if nothing was rendered yet
     * @throws CancellationException as {@link #render}
     */
    public UpdateResult updateReflections(Progress progress) {
        return render(plan(cache().scene(), true), progress);
    }

    /** Whether the mirror images show the scene rendered last. */
    public boolean hasCurrentReflections() {
        return cache().mirroredScene().equals(cache().scene());
    }

    /**
     * What one light gives to the picture, from what is known: no ray is cast, and nothing changes. Equal to the picture of
     * {@link LightImage#scene}, mirrors included, over the samples of this picture.
     *
     * @param light the name; all is black where no light has it
     * @throws IllegalStateException if nothing was rendered yet, or mirror levels are kept as hit shapes
     * @throws CancellationException if {@code progress} asked to stop
     */
    public Film lightImage(String light, Progress progress) {
        return LightImage.film(cache(), options, light, workers, progress);
    }

    /** The picture as it is now: later updates make new ones. */
    public Film film() {
        return cache().film();
    }

    /** The scene rendered last, as the view shows it. */
    public Scene scene() {
        return cache().scene();
    }

    /** Whether something is known of a picture. */
    public boolean hasPicture() {
        return cache != null;
    }

    /**
     * What is kept of the picture.
     *
     * @throws IllegalStateException if nothing was rendered yet
     */
    public PixelCache cache() {
        if (cache == null) {
            throw new IllegalStateException("no scene was rendered yet");
        }
        return cache;
    }

    /** What was kept of the last picture that had all its samples, from which {@link #finish} goes on; null where there is none. */
    public PixelCache lastFinishedCache() {
        return pendingSamples == null ? cache : pendingSamples.finishedCache();
    }

    /** The bytes of all that is kept. */
    public long bytes() {
        long newest = cache == null ? 0 : MemoryEstimate.usedBytes(cache);
        return pendingSamples == null || pendingSamples.finishedCache() == null ? newest
                : newest + MemoryEstimate.usedBytes(pendingSamples.finishedCache());
    }

    /** Drops all that is known: the next picture is a first pass. */
    public void clear() {
        restore(null);
        geometrySource.set(null);
    }

    /**
     * Goes back to what was kept of an earlier picture, as if nothing had been asked since: so an edit can be made, and
     * measured, again and again.
     *
     * @param saved what {@link #cache} gave, here or in a renderer that differs in its reflections or threads alone
     */
    public void restore(PixelCache saved) {
        cache = saved;
        pendingSamples = null;
        cacheAccuracy = options.accuracy();
        repeatedEdits.reset();
    }

    /** Leaves things half done where it does not end. */
    private UpdateResult update(PlannedUpdate planned, boolean centersOnly, Progress progress) {
        long start = System.nanoTime() - planned.nanoseconds;
        UpdatePlan plan = planned.difference;
        Scene target = planned.target;
        WorkCounts work = WorkCounts.NONE;
        if (planned.base != cache) {
            cache = planned.base;
            pendingSamples = null;
        } else if (pendingSamples != null && plan instanceof UpdatePlan.Relight next
                && !pendingSamples.canReuseMirrors(cache, next, target)) {
            work = renderSamples(pendingSamples.plan(cache), progress);
        }
        if (needsConversion() && !(plan instanceof UpdatePlan.FirstPass)) {
            work = work.plus(convert(new CacheConversion(cache, options), progress));
            // The same lights and rows, but layers are known in another way.
            plan = difference(target, planned.updatesMirrors);
        }
        UpdatePlan reported = plan instanceof UpdatePlan.Nothing ? planned.update() : plan;
        work = work.plus(switch (plan) {
            case UpdatePlan.Nothing _ -> WorkCounts.NONE;
            case UpdatePlan.FirstPass first -> firstPass(first, target, centersOnly && canDeferSamples(target), progress);
            case UpdatePlan.Relight relight -> relight(relight, target,
                    (centersOnly || pendingSamples != null) && !relight.resampled() && canDeferSamples(target), progress);
        });
        cacheAccuracy = options.accuracy();
        UpdatePlan refresh = options.method().refresh(cache, exposure, curve);
        boolean refreshed = refresh instanceof UpdatePlan.Relight;
        if (refresh instanceof UpdatePlan.Relight relight) {
            work = work.plus(relight(relight, cache.scene(), false, progress));
        }
        double bound = options.method().errorBound(cache);
        if (pendingSamples != null) {
            if (centersOnly) {
                pendingSamples = pendingSamples.plus(work, System.nanoTime() - start);
            } else {
                work = work.plus(renderSamples(pendingSamples.plan(cache), progress));
            }
        }
        return new UpdateResult(reported, work.rowsTouched(), work.rowsComposed(), work.bytesMoved(), work.rays(),
                System.nanoTime() - start,
                bound, refreshed);
    }

    /** Contributions that are scaled are off by what all their scalings lose, and centers and samples must be by the same. */
    private boolean canDeferSamples(Scene target) {
        return options.accuracy().isExact() && RenderJob.needsEdges(target);
    }

    private WorkCounts convert(CacheConversion conversion, Progress progress) {
        CacheConversion.Result result = conversion.run(workers, progress);
        cache = result.cache();
        return result.work();
    }

    /**
     * Refuses a scene whose first pass would not fit into memory.
     *
     * @param reservedBytes bytes that lie beside it
     * @throws PictureTooLargeException if it would not
     */
    public void requireMemory(Scene target, long reservedBytes) {
        checkMemory(options.view().apply(target), reservedBytes);
    }

    private void checkMemory(Scene target, long reservedBytes) {
        MemoryEstimate.check(target, options.withMemory(options.memory() - reservedBytes));
    }

    private WorkCounts firstPass(UpdatePlan.FirstPass plan, Scene target, boolean centersOnly, Progress progress) {
        checkMemory(target, bytes());
        RenderJob job = RenderJob.firstPass(geometrySource.get(target, cache, options.view()), target, options, progress);
        CacheBuilder.BuildResult result = new CacheBuilder(job, workers, null).build(centersOnly);
        cache = result.cache();
        pendingSamples = centersOnly ? new PendingSamples(null, plan) : null;
        return result.work();
    }

    /** What rays of a scene can meet, as a first pass takes it; it is kept for that. */
    public Geometry prepare(Scene target) {
        Geometry prepared = geometrySource.get(options.view().apply(target), cache, options.view());
        geometrySource.set(prepared);
        return prepared;
    }

    /** Lets first passes take what is known elsewhere of the same shapes; null is nothing. */
    public void setSharedGeometry(Geometry geometry) {
        geometrySource.set(geometry);
    }

    private WorkCounts relight(UpdatePlan.Relight plan, Scene target, boolean centersOnly, Progress progress) {
        PixelCache old = cache;
        var scenes = new RenderedScenes(target, plan.mirrors() == null ? old.mirroredScene() : target);
        RenderJob job = RenderJob.relight(repeatedEdits.withKeys(plan), plan.shapes().after(old.geometry()), scenes, options, progress);
        CacheBuilder.BuildResult result = new CacheBuilder(job, workers, old).build(centersOnly);
        cache = result.cache();
        pendingSamples = centersOnly ? pendingSamples == null ? new PendingSamples(old, plan) : pendingSamples.afterUpdate(plan) : null;
        return result.work();
    }

    /** Makes the finer samples of the centers that are known. */
    private WorkCounts renderSamples(UpdatePlan plan, Progress progress) {
        PixelCache finished = pendingSamples.finishedCache();
        CacheBuilder builder = finished != null && plan instanceof UpdatePlan.Relight relight
                ? new CacheBuilder(RenderJob.relight(relight, cache.geometry(), cache.scenes(), options, progress), workers, finished)
                : new CacheBuilder(RenderJob.samples(cache, options, progress), workers, null);
        CacheBuilder.BuildResult result = builder.finish(cache);
        cache = result.cache();
        pendingSamples = null;
        return result.work();
    }

    @Override
    public void close() {
        workers.close();
    }
}
