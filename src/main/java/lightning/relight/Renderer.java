package lightning.relight;

import java.util.concurrent.CancellationException;
import lightning.cache.LayerStamp;
import lightning.cache.PixelCache;
import lightning.effects.Effect;
import lightning.image.DisplayCurve;
import lightning.image.Film;
import lightning.relight.plan.Accuracy;
import lightning.relight.plan.Dispatcher;
import lightning.relight.plan.ErrorBound;
import lightning.relight.plan.LevelPlan;
import lightning.relight.plan.Reflections;
import lightning.relight.plan.UpdatePlan;
import lightning.relight.tile.Job;
import lightning.relight.tile.Options;
import lightning.relight.tile.RepeatedEdit;
import lightning.relight.tile.Tally;
import lightning.relight.tile.TileRun;
import lightning.scene.Antialias;
import lightning.scene.Scene;
import lightning.shading.Sight;
import lightning.trace.Geometry;
import lightning.work.Progress;
import lightning.work.Workers;

/**
 * The running renderer: keeps the pixel cache of one picture and brings it to whatever scene is
 * wanted, with the least work. Not for use by two threads at once.
 */
public final class Renderer implements AutoCloseable {
    private Options options;
    private Workers workers;
    private final RepeatedEdit repeat = new RepeatedEdit();
    private final RepeatedEdit mirroredRepeat = new RepeatedEdit();
    private PixelCache cache;
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
     * Tells how the film is shown, which decides when an error of level ratio would become visible.
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

    /** What {@link #render} would do. */
    public UpdatePlan plan(Scene wanted) {
        UpdatePlan plan = difference(options.view().of(wanted), options.reflections() == Reflections.CURRENT);
        return plan instanceof UpdatePlan.Nothing && converts() ? new Conversion(cache, options).plan() : plan;
    }

    private UpdatePlan difference(Scene wanted, boolean mirrors) {
        return Dispatcher.plan(cache, wanted, mirrors, options.accuracy());
    }

    private boolean converts() {
        return cache != null && known != options.accuracy();
    }

    /**
     * Makes the film show the wanted scene.
     *
     * @throws PictureTooLarge if it needs a first pass that does not fit into memory beside what is known of the picture, which a
     *                         cancelled pass goes back to; everything is then as before the call
     * @throws CancellationException if {@code progress} asked to stop; everything
     *         is then as before the call
     */
    public Update render(Scene wanted, Progress progress) {
        return run(options.view().of(wanted), options.reflections() == Reflections.CURRENT, progress);
    }

    /**
     * Makes the mirror images show the scene rendered last (paper §4.8).
     *
     * @throws IllegalStateException if nothing was rendered yet
     * @throws CancellationException as {@link #render}
     */
    public Update updateReflections(Progress progress) {
        return run(cache().scene(), true, progress);
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
        return LightShare.film(cache(), options.view(), light, workers, progress);
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

    /** Drops all that is known: the next picture is a first pass. */
    public void forget() {
        restore(null);
    }

    /**
     * Goes back to what was kept of an earlier picture, as if nothing had been asked since: so an edit can be made, and
     * measured, again and again.
     *
     * @param kept what {@link #cache} gave, here or in a renderer that differs in its reflections or threads alone
     */
    public void restore(PixelCache kept) {
        cache = kept;
        known = options.accuracy();
        repeat.end();
        mirroredRepeat.end();
    }

    private Update run(Scene wanted, boolean mirrors, Progress progress) {
        PixelCache before = cache;
        Accuracy knownBefore = known;
        try {
            return update(wanted, mirrors, progress);
        } catch (CancellationException e) {
            cache = before;
            known = knownBefore;
            throw e;
        }
    }

    /** Leaves things half done where it is cancelled. */
    private Update update(Scene wanted, boolean mirrors, Progress progress) {
        long start = System.nanoTime();
        UpdatePlan plan = difference(wanted, mirrors);
        UpdatePlan told = plan;
        Tally work = Tally.NONE;
        if (converts() && !(plan instanceof UpdatePlan.FirstPass)) {
            var conversion = new Conversion(cache, options);
            work = convert(conversion, progress);
            plan = difference(wanted, mirrors);
            told = plan instanceof UpdatePlan.Nothing ? conversion.plan() : plan;
        }
        work = work.plus(switch (plan) {
            case UpdatePlan.Nothing _ -> Tally.NONE;
            case UpdatePlan.FirstPass _ -> firstPass(wanted, progress);
            case UpdatePlan.Relight relight -> relight(relight, wanted, progress);
        });
        known = options.accuracy();
        ErrorBound bound = ErrorBound.of(cache);
        boolean refreshed = bound.shows(exposure, curve);
        if (refreshed) {
            work = work.plus(relight(Dispatcher.refresh(cache), cache.scene(), progress));
            bound = ErrorBound.of(cache);
        }
        return new Update(told, work.rowsTouched(), work.rowsComposed(), work.bytesMoved(), work.rays(), System.nanoTime() - start,
                bound.largest(), refreshed);
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

    private Tally firstPass(Scene wanted, Progress progress) {
        checkMemory(wanted, cache == null ? 0 : MemoryNeed.of(cache));
        boolean coding = wanted.picture().sampling().antialias() == Antialias.EDGES;
        // Anti-aliasing looks into mirrors for edges, so what mirrors nothing must not be followed then.
        boolean everyMirror = options.view().forces(Effect.REFLECTION) && !coding;
        Geometry geometry = cache == null ? new Geometry(wanted, everyMirror) : cache.geometry().forScene(wanted, everyMirror);
        Job.Shown shown = Job.Shown.of(geometry, wanted);
        LayerStamp[] stamps = new LayerStamp[shown.lamps().length];
        for (int l = 0; l < stamps.length; l++) {
            stamps[l] = shown.lamps()[l].isDark() ? null : LayerStamp.fresh(shown.lamps()[l].light());
        }
        TileRun run = new TileRun(new Job(shown, shown, options, null, null, coding, progress), workers, null);
        cache = new PixelCache(shown.geometry(), run.tiles(), run.fine(), Sight.of(wanted), stamps, stamps);
        return run.work();
    }

    private Tally relight(UpdatePlan.Relight plan, Scene wanted, Progress progress) {
        PixelCache old = cache;
        boolean mirrors = plan.mirrors() != null;
        Job.Shown shown = Job.Shown.of(old.geometry(), wanted);
        Job.Shown mirrored = mirrors ? shown : Job.Shown.of(old.geometry(), old.mirroredScene());
        Job job = new Job(shown, mirrored, options, Job.Level.of(plan.top(), old.scene(), shown.lamps(), repeat),
                mirrors ? Job.Level.of(plan.mirrors(), old.mirroredScene(), shown.lamps(), mirroredRepeat) : null,
                wanted.picture().sampling().antialias() == Antialias.EDGES, progress);
        TileRun run = new TileRun(job, workers, old);
        cache = new PixelCache(shown.geometry(), run.tiles(), run.fine(), new Sight(wanted, mirrored.scene()),
                stamps(plan.top(), run.leastFalloff()),
                mirrors ? stamps(plan.mirrors(), run.leastFalloff()) : old.mirroredStamps());
        return run.work();
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
