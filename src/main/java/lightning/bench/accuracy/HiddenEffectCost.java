package lightning.bench.accuracy;

import java.util.List;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.engine.choice.Engines;
import lightning.render.image.Film;
import lightning.render.measure.InterleavedTimer;
import lightning.render.measure.Timing;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.scene.Scene;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;

/**
 * First passes of a scene that does not use an effect, in turns with those of a scene that uses it while the view hides it.
 *
 * @param absent      first passes without the effect
 * @param hidden      first passes with the hidden effect
 * @param bytes       bytes of the cache without the effect
 * @param hiddenBytes bytes of the cache with the hidden effect
 * @param rays        rays without the effect
 * @param hiddenRays  rays with the hidden effect
 * @param equal       whether both images are equal in every bit
 */
public record HiddenEffectCost(Timing absent, Timing hidden, long bytes, long hiddenBytes, long rays, long hiddenRays, boolean equal) {

    /**
     * Measures both.
     *
     * @param without     scene that does not use the effect
     * @param with        the same scene with it
     * @param repetitions number of samples, ≥ 1
     * @throws java.util.concurrent.CancellationException if {@code progress} requests a stop
     */
    public static HiddenEffectCost of(Scene without, Scene with, RenderEffect effect, RenderOptions options, int repetitions,
            Progress progress) {
        try (Renderer absent = new Renderer(options.withEngines(Engines.FASTEST));
                Renderer hidden = new Renderer(
                        options.withEngines(Engines.FASTEST).withView(ViewEffects.ALL.withHidden(List.of(effect))))) {
            UpdateResult[] last = new UpdateResult[2];
            List<InterleavedTimer.TimedTask<RuntimeException>> tasks = List.of(
                    () -> (last[0] = firstPass(absent, without, progress)).milliseconds(),
                    () -> (last[1] = firstPass(hidden, with, progress)).milliseconds());
            InterleavedTimer timer = new InterleavedTimer(repetitions, repetitions == 1 ? 0 : 1000);
            List<Timing> times = timer.warmUpAndMeasure(tasks, progress.cancellationOnly());
            Film film = absent.film();
            return new HiddenEffectCost(times.get(0), times.get(1), absent.cache().bytes(), hidden.cache().bytes(),
                    last[0].rays().total(), last[1].rays().total(), film.hasSameBits(hidden.film()));
        }
    }

    private static UpdateResult firstPass(Renderer renderer, Scene scene, Progress progress) {
        renderer.clear();
        return renderer.render(scene, progress.cancellationOnly());
    }
}
