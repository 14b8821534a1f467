package lightning.render.relight;

import java.util.concurrent.CancellationException;
import java.util.function.Supplier;
import lightning.base.work.Progress;
import lightning.base.work.Workers;
import lightning.render.cache.PixelCache;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Film;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.Dispatcher;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.CacheBuilder;
import lightning.render.relight.tile.Job;
import lightning.render.relight.tile.Options;
import lightning.render.relight.tile.RepeatedEdit;
import lightning.render.relight.tile.Tally;
import lightning.render.shading.SeenScenes;
import lightning.render.trace.Geometry;
import lightning.scene.Scene;

/**
 * The running renderer: keeps the pixel cache of one picture and brings it to whatever scene is
 * wanted, with the least work. Not for use by two threads at once.
 */
public final class Renderer implements AutoCloseable {
    private Options options;
    private Workers workers;
    private final RepeatedEdit.Levels repeats = new RepeatedEdit.Levels();
    private PixelCache cache;
    /** What the cache lacks, where it holds pixels' centres alone; else null. */
    private Unfinished unfinished;
    private final GeometryOffer offer = new GeometryOffer();
    /** How the cache is known; its accuracy differs from the wanted one after a change, until the next update. */
    private Accuracy known;
    private double exposure;
    private DisplayCurve curve = DisplayCurve.SRGB;

    public Renderer(Options options) {
        this.options = options;
        workers = new Workers(options.threads());
    }

    public Options options() {
        return options;
    }

    /**
     * Tells how the film is shown, which decides when an error of accuracy ratio would become visible.
     *
     * @param stops the exposure, in stops
     */
    public void setView(double stops, DisplayCurve shown) {
        exposure = stops;
        curve = shown;
    }

    /**
     * Goes on in another way of working. What is known is kept, and brought to another accuracy by the next update, without
     * a ray; only another view, or another storage of mirror levels, forgets it.
     */
    public void change(Options to) {
        if (unfinished != null && (to.accuracy() != options.accuracy() || to.reflections() != options.reflections())) {
            // Samples could not follow centres that are known in another way.
            restore(unfinished.whole());
        }
        if (to.threads() != options.threads()) {
            workers.close();
            workers = new Workers(to.threads());
        }
        boolean serves = to.view().tracesLike(options.view()) && to.storage() == options.storage()
                && (to.accuracy() == known || cache == null || Conversion.serves(cache));
        options = to;
        if (!serves) {
            forget();
        }
    }

    /** What it takes to make the film show the wanted scene. */
    public PlannedUpdate plan(Scene wanted) {
        return plan(options.view().of(wanted), options.reflections() == Reflections.CURRENT);
    }

    private PlannedUpdate plan(Scene wanted, boolean mirrors) {
        long start = System.nanoTime();
        Unfinished.Start way = unfinished == null ? new Unfinished.Start(cache, difference(wanted, mirrors))
                : unfinished.start(cache, wanted, mirrors);
        UpdatePlan told = way.plan() instanceof UpdatePlan.Nothing && converts() ? new Conversion(cache, options).plan() : way.plan();
        return new PlannedUpdate(wanted, mirrors, way.plan(), told, way.from(), cache, System.nanoTime() - start);
    }

    private UpdatePlan difference(Scene wanted, boolean mirrors) {
        return Dispatcher.plan(cache, wanted, mirrors, options.method());
    }

    private boolean converts() {
        return cache != null && known != options.accuracy();
    }

    /**
     * Makes the film show the wanted scene. Whatever is thrown, an {@link OutOfMemoryError} included, everything is then as before the
     * call.
     *
     * @throws PictureTooLarge if it needs a first pass that does not fit into memory beside what is known of the picture, which a
     *                         cancelled pass goes back to
     * @throws CancellationException if {@code progress} asked to stop
     */
    public Update render(Scene wanted, Progress progress) {
        return render(plan(wanted), progress);
    }

    /**
     * The same; where a first pass does not fit beside what is known of the picture, it begins without that.
     *
     * @throws PictureTooLarge       if it does not fit even so; nothing is known then
     * @throws CancellationException likewise
     */
    public Update renderOrForget(Scene wanted, Progress progress) {
        try {
            return render(wanted, progress);
        } catch (PictureTooLarge e) {
            if (!hasPicture()) {
                throw e;
            }
            forget();
            return render(wanted, progress);
        }
    }

    /**
     * Does what was planned; where something else is known of the picture since, it is planned anew.
     *
     * @param planned by {@link #plan}
     * @throws PictureTooLarge       as {@link #render(Scene, Progress)}
     * @throws CancellationException likewise
     */
    public Update render(PlannedUpdate planned, Progress progress) {
        return orAsBefore(() -> update(again(planned), false, progress));
    }

    /**
     * Does what was planned, and leaves it to {@link #finish} to make the finer samples where only edges have them: the film then
     * shows the pixels' centres, as if there were no anti-aliasing. Updates go on from there, whether it was finished or not.
     *
     * @param planned by {@link #plan}
     * @throws PictureTooLarge       as {@link #render(Scene, Progress)}
     * @throws CancellationException likewise
     */
    public Update renderCenters(PlannedUpdate planned, Progress progress) {
        return orAsBefore(() -> update(again(planned), true, progress));
    }

    /** Whether the film has all samples that its scene asks for. */
    public boolean isFinished() {
        return unfinished == null;
    }

    /**
     * Makes the finer samples that {@link #renderCenters} left out.
     *
     * @return all that was done since the last picture that had its samples; where none had them yet, since the newest edit
     * @throws IllegalStateException if the picture is finished
     * @throws CancellationException if {@code progress} asked to stop; everything is then as before the call
     */
    public Update finish(Progress progress) {
        if (unfinished == null) {
            throw new IllegalStateException("the picture is finished");
        }
        long start = System.nanoTime();
        Unfinished left = unfinished;
        UpdatePlan plan = left.plan(cache);
        Tally work = left.work().plus(samples(plan, progress));
        return new Update(plan, work.rowsTouched(), work.rowsComposed(), work.bytesMoved(), work.rays(),
                left.nanoseconds() + System.nanoTime() - start, 0, false);
    }

    private PlannedUpdate again(PlannedUpdate planned) {
        return planned.startsFrom(cache) ? planned : plan(planned.wanted, planned.mirrors);
    }

    /** Goes back to what is known now if the work does not end, for whatever reason. */
    private Update orAsBefore(Supplier<Update> work) {
        PixelCache before = cache;
        Unfinished unfinishedBefore = unfinished;
        Accuracy knownBefore = known;
        Update update = null;
        try {
            update = work.get();
            return update;
        } finally {
            if (update == null) {
                cache = before;
                unfinished = unfinishedBefore;
                known = knownBefore;
            }
        }
    }

    /**
     * Makes the mirror images show the scene rendered last (paper §4.8).
     *
     * @throws IllegalStateException if nothing was rendered yet
     * @throws CancellationException as {@link #render}
     */
    public Update updateReflections(Progress progress) {
        return render(plan(cache().scene(), true), progress);
    }

    /** Whether the mirror images show the scene rendered last. */
    public boolean reflectionsAreCurrent() {
        return cache().mirroredScene().equals(cache().scene());
    }

    /**
     * What one light gives to the picture, from what is known: no ray is cast, and nothing changes. Equal to the picture of
     * {@link LightShare#scene}, mirrors included, over the samples of this picture.
     *
     * @param light the name; all is black where no light has it
     * @throws IllegalStateException if nothing was rendered yet, or mirror levels are kept as hit shapes
     * @throws CancellationException if {@code progress} asked to stop
     */
    public Film share(String light, Progress progress) {
        return LightShare.film(cache(), options, light, workers, progress);
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
            throw new IllegalStateException("nothing was rendered yet");
        }
        return cache;
    }

    /** What was kept of the last picture that had all its samples, from which {@link #finish} goes on; null where there is none. */
    public PixelCache finishedCache() {
        return unfinished == null ? cache : unfinished.whole();
    }

    /** The bytes of all that is kept. */
    public long bytes() {
        long newest = cache == null ? 0 : MemoryNeed.of(cache);
        return unfinished == null || unfinished.whole() == null ? newest : newest + MemoryNeed.of(unfinished.whole());
    }

    /** Drops all that is known: the next picture is a first pass. */
    public void forget() {
        restore(null);
        offer.set(null);
    }

    /**
     * Goes back to what was kept of an earlier picture, as if nothing had been asked since: so an edit can be made, and
     * measured, again and again.
     *
     * @param kept what {@link #cache} gave, here or in a renderer that differs in its reflections or threads alone
     */
    public void restore(PixelCache kept) {
        cache = kept;
        unfinished = null;
        known = options.accuracy();
        repeats.end();
    }

    /** Leaves things half done where it does not end. */
    private Update update(PlannedUpdate planned, boolean centersAlone, Progress progress) {
        long start = System.nanoTime() - planned.nanoseconds;
        UpdatePlan plan = planned.difference;
        Scene wanted = planned.wanted;
        Tally work = Tally.NONE;
        if (planned.base != cache) {
            cache = planned.base;
            unfinished = null;
        } else if (unfinished != null && plan instanceof UpdatePlan.Relight next && !unfinished.mirrorsFollow(cache, next, wanted)) {
            work = samples(unfinished.plan(cache), progress);
        }
        if (converts() && !(plan instanceof UpdatePlan.FirstPass)) {
            work = work.plus(convert(new Conversion(cache, options), progress));
            // The same lights and rows, but layers are known in another way.
            plan = difference(wanted, planned.mirrors);
        }
        UpdatePlan told = plan instanceof UpdatePlan.Nothing ? planned.update() : plan;
        work = work.plus(switch (plan) {
            case UpdatePlan.Nothing _ -> Tally.NONE;
            case UpdatePlan.FirstPass first -> firstPass(first, wanted, centersAlone && samplesMayFollow(wanted), progress);
            case UpdatePlan.Relight relight -> relight(relight, wanted,
                    (centersAlone || unfinished != null) && !relight.resampled() && samplesMayFollow(wanted), progress);
        });
        known = options.accuracy();
        UpdatePlan refresh = options.method().refresh(cache, exposure, curve);
        boolean refreshed = refresh instanceof UpdatePlan.Relight;
        if (refresh instanceof UpdatePlan.Relight relight) {
            work = work.plus(relight(relight, cache.scene(), false, progress));
        }
        double bound = options.method().errorBound(cache);
        if (unfinished != null) {
            if (centersAlone) {
                unfinished = unfinished.plus(work, System.nanoTime() - start);
            } else {
                work = work.plus(samples(unfinished.plan(cache), progress));
            }
        }
        return new Update(told, work.rowsTouched(), work.rowsComposed(), work.bytesMoved(), work.rays(), System.nanoTime() - start,
                bound, refreshed);
    }

    /** Contributions that are scaled are off by what all their scalings lose, and centres and samples must be by the same. */
    private boolean samplesMayFollow(Scene wanted) {
        return options.accuracy().isExact() && Job.seeksEdges(wanted);
    }

    private Tally convert(Conversion conversion, Progress progress) {
        Conversion.Result result = conversion.run(workers, progress);
        cache = result.cache();
        return result.work();
    }

    /**
     * Refuses a scene whose first pass would not fit into memory.
     *
     * @param kept bytes that lie beside it
     * @throws PictureTooLarge if it would not
     */
    public void check(Scene wanted, long kept) {
        checkMemory(options.view().of(wanted), kept);
    }

    private void checkMemory(Scene wanted, long kept) {
        MemoryNeed.check(wanted, options.withMemory(options.memory() - kept));
    }

    private Tally firstPass(UpdatePlan.FirstPass plan, Scene wanted, boolean centersAlone, Progress progress) {
        checkMemory(wanted, bytes());
        Job job = Job.firstPass(offer.take(wanted, cache, options.view()), wanted, options, progress);
        CacheBuilder.Built built = new CacheBuilder(job, workers, null).build(centersAlone);
        cache = built.cache();
        unfinished = centersAlone ? new Unfinished(null, plan) : null;
        return built.work();
    }

    /** What rays of a scene can meet, as a first pass takes it; it is kept for that. */
    public Geometry prepare(Scene wanted) {
        Geometry prepared = offer.take(options.view().of(wanted), cache, options.view());
        offer.set(prepared);
        return prepared;
    }

    /** Lets first passes take what is known elsewhere of the same shapes; null is nothing. */
    public void share(Geometry geometry) {
        offer.set(geometry);
    }

    private Tally relight(UpdatePlan.Relight plan, Scene wanted, boolean centersAlone, Progress progress) {
        PixelCache old = cache;
        var scenes = new SeenScenes(wanted, plan.mirrors() == null ? old.mirroredScene() : wanted);
        Job job = Job.relight(repeats.next(plan), plan.shapes().after(old.geometry()), scenes, options, progress);
        CacheBuilder.Built built = new CacheBuilder(job, workers, old).build(centersAlone);
        cache = built.cache();
        unfinished = centersAlone ? unfinished == null ? new Unfinished(old, plan) : unfinished.next(plan) : null;
        return built.work();
    }

    /** Makes the finer samples of the centres that are known. */
    private Tally samples(UpdatePlan plan, Progress progress) {
        PixelCache whole = unfinished.whole();
        CacheBuilder builder = whole != null && plan instanceof UpdatePlan.Relight relight
                ? new CacheBuilder(Job.relight(relight, cache.geometry(), cache.scenes(), options, progress), workers, whole)
                : new CacheBuilder(Job.samples(cache, options, progress), workers, null);
        CacheBuilder.Built built = builder.finish(cache);
        cache = built.cache();
        unfinished = null;
        return built.work();
    }

    @Override
    public void close() {
        workers.close();
    }
}
