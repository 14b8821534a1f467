package lightning.render.relight;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Film;
import lightning.render.relight.plan.Dispatcher;
import lightning.render.relight.plan.PathUpdate;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.trace.Geometry;
import lightning.scene.Contribution;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Incremental renderer: owns the pixel cache of one picture and updates it to any target scene with the least work. Not thread-safe. */
public final class Renderer implements AutoCloseable {
    private RenderOptions options;
    private WorkerPool workers;
    private PictureState state = new PictureState.Empty();
    private final GeometrySource geometrySource = new GeometrySource();
    /** Absent if pictures are rendered without a check, until the paths of their indirect light exceed the memory. */
    private final Optional<MemoryCheck> memoryCheck;
    private double exposure;
    private DisplayCurve curve = DisplayCurve.SRGB;

    public Renderer(RenderOptions options) {
        this(options, Optional.of(new MemoryCheck()));
    }

    private Renderer(RenderOptions options, Optional<MemoryCheck> memoryCheck) {
        this.options = options;
        this.memoryCheck = memoryCheck;
        workers = new WorkerPool(options.threads());
    }

    /** Returns a renderer that does not check the memory of pictures before it renders them. */
    static Renderer unchecked(RenderOptions options) {
        return new Renderer(options, Optional.empty());
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
        if (!state.isFinished()
                && !(to.method().equals(options.method()) && to.keepsReflectionsCurrent() == options.keepsReflectionsCurrent())) {
            // Samples cannot follow centers of another method.
            restore(state.lastFinished());
        }
        if (to.threads() != options.threads()) {
            workers.close();
            workers = new WorkerPool(to.threads());
        }
        boolean canReuse = to.view().hasSameTrace(options.view()) && to.storage() == options.storage()
                && (!state.needsConversion(to.method()) || CacheConversion.canConvert(state.picture()));
        options = to;
        if (!canReuse) {
            clear();
        }
    }

    /** Plans the update of the film to the target scene. */
    public PlannedUpdate plan(Scene target) {
        return plan(options.view().apply(target), options.keepsReflectionsCurrent());
    }

    /** Plans the update of the film to the target scene, with mirror images if they show the scene rendered last. */
    private PlannedUpdate planKeepingReflectionsCurrent(Scene target) {
        return plan(options.view().apply(target), options.keepsReflectionsCurrent() || cache().hasCurrentReflections());
    }

    /**
     * Plans the update of the film to the target scene, as {@link #planKeepingReflectionsCurrent}. Starts from an earlier picture if paths
     * of its indirect light can be kept and mirrors then show the target scene in any case.
     *
     * @param earlier cache of a finished picture by this renderer with its current options
     */
    public PlannedUpdate planFrom(@Nullable PixelCache earlier, Scene target) {
        PlannedUpdate planned = planKeepingReflectionsCurrent(target);
        if (earlier == null || !planned.updatesMirrors()) {
            return planned;
        }
        PixelCache newest = cache();
        Geometry geometry = newest.geometry().canServe(planned.target()) ? newest.geometry() : null;
        UpdatePlan difference = Dispatcher.plan(earlier, planned.target(), geometry, true, options.method());
        boolean keepsPaths = difference instanceof UpdatePlan.Relight relight
                && (relight.paths() == PathUpdate.KEEP || relight.paths() == PathUpdate.REPEAT);
        return keepsPaths ? new PlannedUpdate(planned.target(), true, difference, difference, earlier, newest, planned.nanoseconds())
                : planned;
    }

    private PlannedUpdate plan(Scene target, boolean mirrors) {
        long start = System.nanoTime();
        PixelCache newest = state.newest();
        PendingSamples.Start base = state instanceof PictureState.CentersOnly unfinished
                ? unfinished.samples().chooseStart(unfinished.centers(), target, mirrors)
                : new PendingSamples.Start(newest, Dispatcher.plan(newest, target, mirrors, options.method()));
        UpdatePlan reported = base.plan() instanceof UpdatePlan.Nothing && state.needsConversion(options.method())
                ? new CacheConversion(state.picture(), options).plan() : base.plan();
        return new PlannedUpdate(target, mirrors, base.plan(), reported, base.from(), newest, System.nanoTime() - start);
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
            if (!state.hasPicture()) {
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
        return finishStep(updateWith(progress).run(state, replanIfStale(planned), false));
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
        return finishStep(updateWith(progress).run(state, replanIfStale(planned), true));
    }

    /**
     * Updates the film to the target scene, with finer samples if the picture has those that its scene requires.
     *
     * @throws PictureTooLargeException as {@link #render(Scene, Progress)}
     * @throws CancellationException if {@code progress} requested cancellation
     */
    public UpdateResult renderWithSameSamples(Scene target, Progress progress) {
        return state.isFinished() ? render(target, progress) : renderCenters(plan(target), progress);
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
        if (!(state instanceof PictureState.CentersOnly unfinished)) {
            throw new IllegalStateException("the picture is already finished");
        }
        return finishStep(updateWith(progress).finish(unfinished));
    }

    private PlannedUpdate replanIfStale(PlannedUpdate planned) {
        return planned.isPlannedFor(state.newest()) ? planned : plan(planned.target(), planned.updatesMirrors());
    }

    private PictureUpdate updateWith(Progress progress) {
        return new PictureUpdate(options, workers, geometrySource, memoryCheck, exposure, curve, progress);
    }

    private UpdateResult finishStep(PictureUpdate.Outcome outcome) {
        state = outcome.state();
        return outcome.result();
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

    /**
     * Returns a contribution to the picture, over its samples: of a light with its visible face and its bulbs, or of an environment with its
     * background. Casts no ray and changes nothing.
     *
     * @param contribution the film is black if the scene does not have it
     * @throws IllegalStateException if no scene was rendered yet, or mirror levels are stored as hit shapes
     */
    public Film contribution(Contribution contribution, Progress progress) {
        PictureFilms films = new PictureFilms(cache(), options);
        return films.only(films.parts().of(contribution)).sum(workers, progress);
    }

    /** Returns what it holds of its picture; later updates make new states. */
    public PictureState state() {
        return state;
    }

    /** Returns the current picture; later updates create new films. */
    public Film film() {
        return cache().film();
    }

    /** Returns the scene rendered last, as the view shows it. */
    public Scene scene() {
        return cache().scene();
    }

    /**
     * Returns the cache of the picture.
     *
     * @throws IllegalStateException if no scene was rendered yet
     */
    public PixelCache cache() {
        PixelCache newest = state.newest();
        if (newest == null) {
            throw new IllegalStateException("no scene was rendered yet");
        }
        return newest;
    }

    /** Discards the cache: the next picture is a first pass. */
    public void clear() {
        restore(null);
        geometrySource.set(null);
    }

    /**
     * Restores an earlier cache, as if no update had run since, so that an edit can be repeated and measured.
     *
     * @param saved result of {@link #cache}, from this renderer or one that differs only in its reflection mode or threads; may lack the finer
     *         samples of its scene
     */
    public void restore(@Nullable PixelCache saved) {
        state = PictureState.of(saved, options.method());
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
        PictureUpdate update = updateWith(progress);
        update.checkMemory(shown, reservedBytes, update.canDeferSamples(shown), previews);
    }

    /** Returns the geometry of a scene. Callable from threads of an update. */
    public Geometry geometryOf(Scene target) {
        return geometrySource.get(options.view().apply(target), state.newest(), options.view());
    }

    /** Prepares the geometry of a scene for its first pass and caches it. */
    public Geometry prepare(Scene target) {
        Geometry prepared = geometryOf(target);
        geometrySource.set(prepared);
        return prepared;
    }

    /** Sets geometry for first passes to reuse if it has the same shapes; null removes it. */
    public void setSharedGeometry(@Nullable Geometry geometry) {
        geometrySource.set(geometry);
    }

    @Override
    public void close() {
        workers.close();
    }
}
