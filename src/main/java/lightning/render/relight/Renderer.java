package lightning.render.relight;

import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import java.util.function.Supplier;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.cache.PixelCache;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Film;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.Dispatcher;
import lightning.render.relight.plan.PathUpdate;
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

/** Incremental renderer: owns the pixel cache of one picture and updates it to any target scene with the least work. Not thread-safe. */
public final class Renderer implements AutoCloseable {
    private RenderOptions options;
    private WorkerPool workers;
    private final RepeatedEditDetector.LevelDetectors repeatedEdits = new RepeatedEditDetector.LevelDetectors();
    private PixelCache cache;
    /** Samples missing from the cache if it holds only pixel centers; otherwise null. */
    private PendingSamples pendingSamples;
    private final GeometrySource geometrySource = new GeometrySource();
    /** Null if pictures are rendered without a check, until the paths of their indirect light exceed the memory. */
    private final MemoryCheck memoryCheck;
    /** Accuracy of the cache. It differs from the options after a change, until the next update. */
    private Accuracy cacheAccuracy;
    private double exposure;
    private DisplayCurve curve = DisplayCurve.SRGB;

    public Renderer(RenderOptions options) {
        this(options, new MemoryCheck());
    }

    private Renderer(RenderOptions options, MemoryCheck memoryCheck) {
        this.options = options;
        this.memoryCheck = memoryCheck;
        workers = new WorkerPool(options.threads());
    }

    /** Returns a renderer that does not check the memory of pictures before it renders them. */
    static Renderer unchecked(RenderOptions options) {
        return new Renderer(options, null);
    }

    public RenderOptions options() {
        return options;
    }

    /**
     * Sets the display of the film, which decides when an error of accuracy ratio would be visible.
     *
     * @param stops exposure in stops
     */
    public void setView(double stops, DisplayCurve displayCurve) {
        exposure = stops;
        curve = displayCurve;
    }

    /**
     * Switches to new options. Keeps the cache and converts its accuracy on the next update, without casting rays. Discards the
     * cache only if the view or the mirror storage changes.
     */
    public void setOptions(RenderOptions to) {
        if (pendingSamples != null && (to.accuracy() != options.accuracy() || to.reflections() != options.reflections())) {
            // Samples cannot follow centers of another accuracy.
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

    /** Plans the update of the film to the target scene. */
    public PlannedUpdate plan(Scene target) {
        return plan(options.view().apply(target), options.reflections() == ReflectionMode.CURRENT);
    }

    /** Plans the update of the film to the target scene, with mirror images if they show the scene rendered last. */
    public PlannedUpdate planKeepingReflectionsCurrent(Scene target) {
        return plan(options.view().apply(target), options.reflections() == ReflectionMode.CURRENT || hasCurrentReflections());
    }

    /**
     * Plans the update of the film to the target scene, as {@link #planKeepingReflectionsCurrent}. Starts from an earlier picture if paths
     * of its indirect light can be kept and mirrors then show the target scene in any case.
     *
     * @param earlier cache of a finished picture by this renderer with its current options; null for none
     */
    public PlannedUpdate planFrom(PixelCache earlier, Scene target) {
        PlannedUpdate planned = planKeepingReflectionsCurrent(target);
        if (earlier == null || !planned.updatesMirrors) {
            return planned;
        }
        Geometry geometry = cache.geometry().canServe(planned.target) ? cache.geometry() : null;
        UpdatePlan difference = Dispatcher.plan(earlier, planned.target, geometry, true, options.method());
        boolean keepsPaths = difference instanceof UpdatePlan.Relight relight
                && (relight.paths() == PathUpdate.KEEP || relight.paths() == PathUpdate.REPEAT);
        return keepsPaths ? new PlannedUpdate(planned.target, true, difference, difference, earlier, cache, planned.nanoseconds) : planned;
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
     * Updates the film to the target scene. If anything is thrown, {@link OutOfMemoryError} included, the state is as before the
     * call.
     *
     * @throws PictureTooLargeException if it needs a first pass that does not fit into memory next to the current cache, which a
     *         canceled pass would return to
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public UpdateResult render(Scene target, Progress progress) {
        return render(plan(target), progress);
    }

    /**
     * Updates the film to the target scene. If a first pass does not fit next to the current cache, discards the cache first.
     *
     * @throws PictureTooLargeException if it does not fit even then; the cache is then empty
     * @throws CancellationException if {@code progress} requested cancellation
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
     * Runs a planned update; plans again if the cache changed since.
     *
     * @param planned result of {@link #plan}
     * @throws PictureTooLargeException as {@link #render(Scene, Progress)}
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public UpdateResult render(PlannedUpdate planned, Progress progress) {
        return runOrRestore(() -> update(replanIfStale(planned), false, progress));
    }

    /**
     * Runs a planned update without the finer samples at edges, which {@link #finish} adds later. The film then shows pixel
     * centers, as without anti-aliasing. Later updates start from there, finished or not.
     *
     * @param planned result of {@link #plan}
     * @throws PictureTooLargeException as {@link #render(Scene, Progress)}
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public UpdateResult renderCenters(PlannedUpdate planned, Progress progress) {
        return runOrRestore(() -> update(replanIfStale(planned), true, progress));
    }

    /** Returns whether the film has all samples that its scene requires. */
    public boolean isFinished() {
        return pendingSamples == null;
    }

    /**
     * Renders the finer samples that {@link #renderCenters} left out.
     *
     * @return all work since the last picture with samples, or since the newest edit if there was none
     * @throws IllegalStateException if the picture is finished
     * @throws PictureTooLargeException if the first samples of a picture do not fit into memory; the state is then as before the call
     * @throws CancellationException if {@code progress} requested cancellation; the state is then as before the call
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

    /** Runs work and restores the current state if it fails for any reason. */
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
     * Updates the mirror images to the scene rendered last (paper §4.8).
     *
     * @throws IllegalStateException if no scene was rendered yet
     * @throws CancellationException as {@link #render}
     */
    public UpdateResult updateReflections(Progress progress) {
        return render(plan(cache().scene(), true), progress);
    }

    /** Returns whether the mirror images show the scene rendered last. */
    public boolean hasCurrentReflections() {
        return cache().mirroredScene().equals(cache().scene());
    }

    /**
     * Composes the contribution of one light from the cache. Casts no ray and changes nothing. Equals the picture of {@link
     * LightImage#scene}, mirrors included, over the samples of this picture.
     *
     * @param light name of the light; the film is black if no light has it
     * @throws IllegalStateException if no scene was rendered yet, or mirror levels are stored as hit shapes
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public Film lightImage(String light, Progress progress) {
        return LightImage.film(cache(), options, light, workers, progress);
    }

    /** Returns the current picture; later updates create new films. */
    public Film film() {
        return cache().film();
    }

    /** Returns the scene rendered last, as the view shows it. */
    public Scene scene() {
        return cache().scene();
    }

    /** Returns whether a picture is cached. */
    public boolean hasPicture() {
        return cache != null;
    }

    /**
     * Returns the cache of the picture.
     *
     * @throws IllegalStateException if no scene was rendered yet
     */
    public PixelCache cache() {
        if (cache == null) {
            throw new IllegalStateException("no scene was rendered yet");
        }
        return cache;
    }

    /** Returns the cache of the last picture with all its samples, from which {@link #finish} starts; null if there is none. */
    public PixelCache lastFinishedCache() {
        return pendingSamples == null ? cache : pendingSamples.finishedCache();
    }

    /** Returns the bytes of all cached data. */
    public long bytes() {
        long newest = cache == null ? 0 : MemoryEstimate.usedBytes(cache);
        return pendingSamples == null || pendingSamples.finishedCache() == null ? newest
                : newest + MemoryEstimate.usedBytes(pendingSamples.finishedCache());
    }

    /** Discards the cache: the next picture is a first pass. */
    public void clear() {
        restore(null);
        geometrySource.set(null);
    }

    /**
     * Restores an earlier cache, as if no update had run since, so that an edit can be repeated and measured.
     *
     * @param saved result of {@link #cache}, from this renderer or one that differs only in its reflection mode or threads
     */
    public void restore(PixelCache saved) {
        cache = saved;
        pendingSamples = null;
        cacheAccuracy = options.accuracy();
        repeatedEdits.reset();
    }

    /** Leaves an incomplete state if it fails. */
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
            // Lights and rows are the same, but layers have another accuracy.
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

    /** Scaled contributions are off by the loss of all their scalings, and centers and samples must be off by the same. */
    private boolean canDeferSamples(Scene target) {
        return options.accuracy().isExact() && RenderJob.needsEdges(target);
    }

    private WorkCounts convert(CacheConversion conversion, Progress progress) {
        CacheConversion.Result result = conversion.run(workers, progress);
        cache = result.cache();
        return result.work();
    }

    /**
     * Rejects a scene whose first pass by {@link #renderCenters} would not fit into memory. May render small pictures to find out.
     *
     * @param reservedBytes bytes in use next to it
     * @param previews      receives these pictures, for display
     * @throws PictureTooLargeException if it does not fit
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public void requireMemory(Scene target, long reservedBytes, Progress progress, Consumer<Film> previews) {
        Scene shown = options.view().apply(target);
        checkMemory(shown, reservedBytes, canDeferSamples(shown), progress, previews);
    }

    private void checkMemory(Scene target, long reservedBytes, boolean centersOnly, Progress progress, Consumer<Film> previews) {
        if (memoryCheck == null) {
            return;
        }
        memoryCheck.requirePicture(target, options.withMemory(options.memory() - reservedBytes),
                centersOnly ? PictureParts.CENTERS : PictureParts.ALL,
                new SmallPictures(geometrySource.shared(), progress.cancellationOnly(), previews));
    }

    private WorkCounts firstPass(UpdatePlan.FirstPass plan, Scene target, boolean centersOnly, Progress progress) {
        checkMemory(target, bytes(), centersOnly, progress, _ -> {});
        RenderJob job = RenderJob.firstPass(geometrySource.get(target, cache, options.view()), target, options, progress);
        CacheBuilder.BuildResult result = new CacheBuilder(job, workers, null).build(centersOnly);
        cache = result.cache();
        pendingSamples = centersOnly ? new PendingSamples(null, plan) : null;
        return result.work();
    }

    /** Returns the geometry of a scene. Callable from threads of an update. */
    public Geometry geometryOf(Scene target) {
        return geometrySource.get(options.view().apply(target), cache, options.view());
    }

    /** Prepares the geometry of a scene for its first pass and caches it. */
    public Geometry prepare(Scene target) {
        Geometry prepared = geometryOf(target);
        geometrySource.set(prepared);
        return prepared;
    }

    /** Sets geometry for first passes to reuse if it has the same shapes; null removes it. */
    public void setSharedGeometry(Geometry geometry) {
        geometrySource.set(geometry);
    }

    /** @param memory bytes that are free for centers and samples */
    private void checkSampleMemory(Scene target, long memory, Progress progress) {
        if (memoryCheck == null) {
            return;
        }
        memoryCheck.requireSamples(target, cache, options.withMemory(memory),
                new SmallPictures(cache.geometry(), progress.cancellationOnly(), _ -> {}));
    }

    private WorkCounts relight(UpdatePlan.Relight plan, Scene target, boolean centersOnly, Progress progress) {
        PixelCache old = cache;
        if (plan.resampled() && RenderJob.needsEdges(target)) {
            checkSampleMemory(target, options.memory() - (bytes() - old.centerBytes() - old.indirectBytes()), progress);
        }
        var scenes = new RenderedScenes(target, plan.mirrors() == null ? old.mirroredScene() : target);
        RenderJob job = RenderJob.relight(repeatedEdits.withKeys(plan), plan.shapes().after(old.geometry()), scenes, options, progress);
        CacheBuilder.BuildResult result = new CacheBuilder(job, workers, old).build(centersOnly);
        cache = result.cache();
        pendingSamples = centersOnly ? pendingSamples == null ? new PendingSamples(old, plan) : pendingSamples.afterUpdate(plan) : null;
        return result.work();
    }

    /** Renders the finer samples of the cached centers. */
    private WorkCounts renderSamples(UpdatePlan plan, Progress progress) {
        PixelCache finished = pendingSamples.finishedCache();
        if (finished == null) {
            checkSampleMemory(cache.scene(), options.memory(), progress);
        }
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
