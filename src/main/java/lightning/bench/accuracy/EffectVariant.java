package lightning.bench.accuracy;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.render.cache.PixelCache;
import lightning.render.engine.choice.Engines;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.relight.tile.RenderOptions;
import lightning.render.shading.RayCounts;
import lightning.scene.AntialiasMode;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;

/** One way to render a scene and an edit of it: with all that it calls for, without one effect, or with one forced. */
final class EffectVariant implements AutoCloseable {
    /** Bytes of a picture that the collector notices. */
    private static final long LARGE = 1 << 24;

    private final Scene before;
    private final Scene after;
    private final Renderer renderer;
    private PixelCache cache;
    private UpdateResult firstPass;
    private UpdateResult lastUpdate;
    private Timing firstTiming;
    private Timing updateTiming;

    EffectVariant(Scene before, Scene after, RenderOptions options) {
        this.before = before;
        this.after = after;
        renderer = new Renderer(options.withEngines(Engines.FASTEST));
    }

    /** Without an effect that is in use, or with one that is not. Finer samples are forced by asking for them. */
    static EffectVariant of(RenderEffect effect, boolean inUse, Scene before, Scene after, RenderOptions options) {
        ViewEffects view = inUse ? ViewEffects.ALL.with(effect, false) : ViewEffects.ALL.withForced(List.of(effect));
        boolean addsSamples = effect == RenderEffect.ANTIALIASING && !inUse;
        return new EffectVariant(addsSamples ? antialiased(before) : before, addsSamples ? antialiased(after) : after,
                options.withView(view));
    }

    private static Scene antialiased(Scene scene) {
        PictureSettings picture = scene.picture();
        return scene.withPicture(picture.withSampling(new SamplingSettings(AntialiasMode.EDGES, picture.sampling().grid())));
    }

    /** Renders all of them in turns; a single time is for a look, without a warm-up. */
    static void measure(List<EffectVariant> variants, int repetitions, Progress progress) {
        List<InterleavedTimer.TimedTask<RuntimeException>> tasks = new ArrayList<>();
        for (EffectVariant variant : variants) {
            tasks.add(() -> variant.renderFirst(progress.cancellationOnly()));
            tasks.add(() -> variant.renderUpdate(progress.cancellationOnly()));
        }
        InterleavedTimer timer = repetitions == 1 ? new InterleavedTimer(1, 0) : new InterleavedTimer(repetitions);
        List<Timing> times = timer.warmUpAndMeasure(tasks, progress);
        for (int i = 0; i < variants.size(); i++) {
            variants.get(i).firstTiming = times.get(2 * i);
            variants.get(i).updateTiming = times.get(2 * i + 1);
        }
    }

    private double renderFirst(Progress progress) {
        boolean large = cache != null && cache.bytes() > LARGE;
        renderer.clear();
        cache = null;
        if (large) {
            // A pause of the collector is longer than most effects; so it comes here, and in none of the times.
            System.gc();
        }
        firstPass = renderer.render(before, progress);
        cache = renderer.cache();
        return firstPass.milliseconds();
    }

    private double renderUpdate(Progress progress) {
        renderer.restore(cache);
        lastUpdate = renderer.render(after, progress);
        return lastUpdate.milliseconds();
    }

    Timing firstTiming() {
        return firstTiming;
    }

    Timing updateTiming() {
        return updateTiming;
    }

    String plan() {
        return lastUpdate.plan().description();
    }

    /** What is kept of the first pass. */
    PixelCache cache() {
        return cache;
    }

    long bytes() {
        return cache.bytes();
    }

    RayCounts rays() {
        return firstPass.rays();
    }

    @Override
    public void close() {
        renderer.close();
    }
}
