package lightning.render.measure;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.engine.choice.Engines;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.shading.RayCounts;
import lightning.scene.AntialiasMode;
import lightning.scene.PictureSettings;
import lightning.scene.SamplingSettings;
import lightning.scene.Scene;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/** Variant of a scene and its edit for effect costs: plain, without one effect, or with one forced on. */
final class EffectVariant implements AutoCloseable {
    /** Size in bytes from which an image causes notable garbage collection. */
    private static final long LARGE = 1 << 24;

    private final Scene before;
    private final Scene after;
    private final Renderer renderer;
    private @Nullable PixelCache cache;
    private @Nullable UpdateResult firstPass;
    private @Nullable UpdateResult lastUpdate;
    private @Nullable Timing firstTiming;
    private @Nullable Timing updateTiming;

    EffectVariant(Scene before, Scene after, RenderOptions options) {
        this.before = before;
        this.after = after;
        renderer = new Renderer(options.withEngines(Engines.FASTEST));
    }

    /**
     * Returns the variant without an effect in use, or with an unused one forced on. Anti-aliasing is forced on in the picture settings.
     */
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

    /** Renders all variants in turns; a single repetition is a preview without warm-up. */
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
            // Collects garbage here, as a pause during timing is longer than most effects.
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
        return requireNonNull(firstTiming);
    }

    Timing updateTiming() {
        return requireNonNull(updateTiming);
    }

    String plan() {
        return requireNonNull(lastUpdate).plan().description();
    }

    /** Returns the cache of the first pass. */
    PixelCache cache() {
        return requireNonNull(cache);
    }

    long bytes() {
        return cache().bytes();
    }

    RayCounts rays() {
        return requireNonNull(firstPass).rays();
    }

    @Override
    public void close() {
        renderer.close();
    }
}
