package lightning.bench.accuracy;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.render.relight.MemoryEstimate;
import lightning.render.relight.PictureTooLargeException;
import lightning.render.relight.tile.RenderOptions;
import lightning.render.shading.RayCounts;
import lightning.scene.Scene;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.SceneEffects;
import lightning.scene.effects.ViewEffects;

/**
 * What every effect takes on one scene, in its first pass and in the update after one edit.
 *
 * @param first   milliseconds of the first pass
 * @param update  milliseconds of the update
 * @param plan    what the update did, in words
 * @param bytes   bytes of the picture's cache
 * @param effects one for each effect, in their order
 */
public record EffectCosts(Timing first, Timing update, String plan, long bytes, List<EffectCost> effects) {
    public EffectCosts {
        effects = List.copyOf(effects);
    }

    /**
     * Measures them.
     *
     * @param before      the scene
     * @param after       the scene after an edit
     * @param options     how pictures are rendered; its view is not used
     * @param repetitions how often each is rendered, ≥ 1
     * @throws java.util.concurrent.CancellationException if {@code progress} asked to stop
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

    /** The effects that could be measured if there were more memory. */
    public List<RenderEffect> effectsOverMemory() {
        return effects.stream().filter(cost -> !cost.measured() && (cost.inUse() || cost.effect().isForcible())).map(EffectCost::effect)
                .toList();
    }

    /** One effect, measured in turns with the picture as it is, so that two caches at most are held at a time. */
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
            // Finer samples may take twenty times what the picture takes; the other effects are measured all the same.
            return unmeasuredCost(effect, effects);
        }
    }

    private static EffectCost unmeasuredCost(RenderEffect effect, SceneEffects effects) {
        return new EffectCost(effect, effects.users(effect), false, 0, 0, 0, 0, 0, RayCounts.NONE);
    }

    private static double noise(Timing timing) {
        return (timing.upperQuartile() - timing.lowerQuartile()) / 2;
    }

    /** How many effects are measured of a scene, where memory is enough. */
    public static int measurableCount(Scene scene) {
        SceneEffects effects = SceneEffects.of(scene);
        return (int) RenderEffect.ALL.stream().filter(effect -> canMeasure(effect, effects)).count();
    }

    private static boolean canMeasure(RenderEffect effect, SceneEffects effects) {
        return effects.has(effect) || effect.isForcible();
    }
}
