package lightning.render.measure;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.relight.MemoryEstimate;
import lightning.render.relight.PictureTooLargeException;
import lightning.render.shading.RayCounts;
import lightning.scene.Scene;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.SceneEffects;
import lightning.scene.effects.ViewEffects;

/**
 * Costs of every effect on one scene, in its first pass and in the update after one edit.
 *
 * @param first   milliseconds of the first pass
 * @param update  milliseconds of the update
 * @param plan    description of the update's plan
 * @param bytes   bytes of the image's cache
 * @param effects costs per effect, in order
 */
public record EffectCosts(Timing first, Timing update, String plan, long bytes, List<EffectCost> effects) {
    public EffectCosts {
        effects = List.copyOf(effects);
    }

    /**
     * Measures the costs of all effects.
     *
     * @param before      scene
     * @param after       scene after an edit
     * @param options     render options; their view is ignored
     * @param repetitions number of renders of each, ≥ 1
     * @throws java.util.concurrent.CancellationException if {@code progress} requests a stop
     */
    public static EffectCosts of(Scene before, Scene after, RenderOptions options, int repetitions, Progress progress) {
        SceneEffects effects = SceneEffects.of(before);
        try (var plain = new EffectVariant(before, after, options.withView(ViewEffects.ALL))) {
            EffectVariant.measure(List.of(plain), repetitions, progress.cancellationOnly());
            Timing first = plain.firstTiming();
            Timing update = plain.updateTiming();
            List<EffectCost> costs = new ArrayList<>();
            for (RenderEffect effect : RenderEffect.ALL) {
                costs.add(canMeasure(effect, effects) ? compare(plain, effect, effects, before, after, options, repetitions, progress)
                        : unmeasuredCost(effect, effects));
                progress.report(costs.size(), RenderEffect.ALL.size());
            }
            return new EffectCosts(first, update, plain.plan(), plain.bytes(), costs);
        }
    }

    /** Returns the effects that were not measured for lack of memory. */
    public List<RenderEffect> effectsOverMemory() {
        return effects.stream().filter(cost -> !cost.measured() && (cost.inUse() || cost.effect().isForcible())).map(EffectCost::effect)
                .toList();
    }

    /** Measures one effect in turns with the plain image, so that at most two caches are in memory. */
    private static EffectCost compare(EffectVariant plain, RenderEffect effect, SceneEffects effects, Scene before, Scene after,
            RenderOptions options,
            int repetitions, Progress progress) {
        boolean inUse = effects.has(effect);
        try (var variant = EffectVariant.of(effect, inUse, before, after,
                options.withMemory(options.memory() - MemoryEstimate.usedBytes(plain.cache())))) {
            EffectVariant.measure(List.of(plain, variant), repetitions, progress.cancellationOnly());
            EffectVariant withEffect = inUse ? plain : variant;
            EffectVariant withoutEffect = inUse ? variant : plain;
            return new EffectCost(effect, effects.users(effect), true,
                    withEffect.firstTiming().median() - withoutEffect.firstTiming().median(),
                    withEffect.updateTiming().median() - withoutEffect.updateTiming().median(),
                    Math.max(noise(withEffect.firstTiming()), noise(withoutEffect.firstTiming())),
                    Math.max(noise(withEffect.updateTiming()), noise(withoutEffect.updateTiming())),
                    withEffect.bytes() - withoutEffect.bytes(),
                    withEffect.rays().minus(withoutEffect.rays()));
        } catch (PictureTooLargeException | OutOfMemoryError e) {
            // Anti-aliasing samples may need twenty times the memory of the image; other effects are still measured.
            return unmeasuredCost(effect, effects);
        }
    }

    private static EffectCost unmeasuredCost(RenderEffect effect, SceneEffects effects) {
        return new EffectCost(effect, effects.users(effect), false, 0, 0, 0, 0, 0, RayCounts.NONE);
    }

    private static double noise(Timing timing) {
        return (timing.upperQuartile() - timing.lowerQuartile()) / 2;
    }

    /** Returns the number of measurable effects of a scene, given enough memory. */
    public static int measurableCount(Scene scene) {
        SceneEffects effects = SceneEffects.of(scene);
        return (int) RenderEffect.ALL.stream().filter(effect -> canMeasure(effect, effects)).count();
    }

    private static boolean canMeasure(RenderEffect effect, SceneEffects effects) {
        return effects.has(effect) || effect.isForcible();
    }
}
