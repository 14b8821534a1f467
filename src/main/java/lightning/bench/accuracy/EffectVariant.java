package lightning.bench.accuracy;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.render.cache.PixelCache;
import lightning.render.engine.choice.Engines;
import lightning.render.relight.Renderer;
import lightning.render.relight.Update;
import lightning.render.relight.tile.Options;
import lightning.render.shading.TraceCounts;
import lightning.scene.Antialias;
import lightning.scene.Picture;
import lightning.scene.Sampling;
import lightning.scene.Scene;
import lightning.scene.effects.Effect;
import lightning.scene.effects.ViewEffects;

/** One way to render a scene and an edit of it: with all that it calls for, without one effect, or with one forced. */
final class EffectVariant implements AutoCloseable {
    /** Bytes of a picture that the collector notices. */
    private static final long LARGE = 1 << 24;

    private final Scene before;
    private final Scene after;
    private final Renderer renderer;
    private PixelCache kept;
    private Update firstPass;
    private Update edit;
    private Timing first;
    private Timing update;

    EffectVariant(Scene before, Scene after, Options options) {
        this.before = before;
        this.after = after;
        renderer = new Renderer(options.withEngines(Engines.FASTEST));
    }

    /** Without an effect that is in use, or with one that is not. Finer samples are forced by asking for them. */
    static EffectVariant of(Effect effect, boolean inUse, Scene before, Scene after, Options options) {
        ViewEffects view = inUse ? ViewEffects.ALL.with(effect, false) : ViewEffects.ALL.forcing(List.of(effect));
        boolean finer = effect == Effect.ANTIALIASING && !inUse;
        return new EffectVariant(finer ? finer(before) : before, finer ? finer(after) : after, options.withView(view));
    }

    private static Scene finer(Scene scene) {
        Picture picture = scene.picture();
        return scene.withPicture(picture.withSampling(new Sampling(Antialias.EDGES, picture.sampling().grid())));
    }

    /** Renders all of them in turns; a single time is for a look, without a warm-up. */
    static void measure(List<EffectVariant> variants, int repetitions, Progress progress) {
        List<Turns.Turn<RuntimeException>> turns = new ArrayList<>();
        for (EffectVariant variant : variants) {
            turns.add(() -> variant.first(progress.silent()));
            turns.add(() -> variant.update(progress.silent()));
        }
        Turns often = repetitions == 1 ? new Turns(1, 0) : new Turns(repetitions);
        List<Timing> times = often.take(turns, progress);
        for (int i = 0; i < variants.size(); i++) {
            variants.get(i).first = times.get(2 * i);
            variants.get(i).update = times.get(2 * i + 1);
        }
    }

    private double first(Progress progress) {
        boolean large = kept != null && kept.bytes() > LARGE;
        renderer.forget();
        kept = null;
        if (large) {
            // A pause of the collector is longer than most effects; so it comes here, and in none of the times.
            System.gc();
        }
        firstPass = renderer.render(before, progress);
        kept = renderer.cache();
        return firstPass.milliseconds();
    }

    private double update(Progress progress) {
        renderer.restore(kept);
        edit = renderer.render(after, progress);
        return edit.milliseconds();
    }

    Timing first() {
        return first;
    }

    Timing update() {
        return update;
    }

    String plan() {
        return edit.plan().text();
    }

    /** What is kept of the first pass. */
    PixelCache kept() {
        return kept;
    }

    long bytes() {
        return kept.bytes();
    }

    TraceCounts rays() {
        return firstPass.rays();
    }

    @Override
    public void close() {
        renderer.close();
    }
}
