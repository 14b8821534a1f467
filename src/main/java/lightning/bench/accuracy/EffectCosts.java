package lightning.bench.accuracy;

import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.render.relight.MemoryNeed;
import lightning.render.relight.PictureTooLarge;
import lightning.render.relight.tile.Options;
import lightning.render.shading.TraceCounts;
import lightning.scene.Scene;
import lightning.scene.effects.Effect;
import lightning.scene.effects.Effects;
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
    public static EffectCosts of(Scene before, Scene after, Options options, int repetitions, Progress progress) {
        Effects effects = Effects.of(before);
        try (var plain = new EffectVariant(before, after, options.withView(ViewEffects.ALL))) {
            EffectVariant.measure(List.of(plain), repetitions, progress.silent());
            Timing first = plain.first();
            Timing update = plain.update();
            List<EffectCost> costs = new ArrayList<>();
            for (Effect effect : Effect.ALL) {
                costs.add(canMeasure(effect, effects) ? beside(plain, effect, effects, before, after, options, repetitions, progress)
                        : unmeasured(effect, effects));
                progress.tiles(costs.size(), Effect.ALL.size());
            }
            return new EffectCosts(first, update, plain.plan(), plain.bytes(), costs);
        }
    }

    /** The effects that could be measured if there were more memory. */
    public List<Effect> tooLarge() {
        return effects.stream().filter(cost -> !cost.measured() && (cost.inUse() || cost.effect().isForcible())).map(EffectCost::effect)
                .toList();
    }

    /** One effect, measured in turns with the picture as it is, so that two caches at most are held at a time. */
    private static EffectCost beside(EffectVariant plain, Effect effect, Effects effects, Scene before, Scene after, Options options,
            int repetitions, Progress progress) {
        boolean inUse = effects.has(effect);
        try (var other = EffectVariant.of(effect, inUse, before, after,
                options.withMemory(options.memory() - MemoryNeed.of(plain.kept())))) {
            EffectVariant.measure(List.of(plain, other), repetitions, progress.silent());
            EffectVariant with = inUse ? plain : other;
            EffectVariant without = inUse ? other : plain;
            return new EffectCost(effect, effects.callers(effect), true, with.first().median() - without.first().median(),
                    with.update().median() - without.update().median(),
                    Math.max(noise(with.first()), noise(without.first())), Math.max(noise(with.update()), noise(without.update())),
                    with.bytes() - without.bytes(),
                    with.rays().minus(without.rays()));
        } catch (PictureTooLarge | OutOfMemoryError e) {
            // Finer samples may take twenty times what the picture takes; the other effects are measured all the same.
            return unmeasured(effect, effects);
        }
    }

    private static EffectCost unmeasured(Effect effect, Effects effects) {
        return new EffectCost(effect, effects.callers(effect), false, 0, 0, 0, 0, 0, TraceCounts.NONE);
    }

    private static double noise(Timing timing) {
        return (timing.upperQuartile() - timing.lowerQuartile()) / 2;
    }

    /** How many effects are measured of a scene, where memory is enough. */
    public static int measurable(Scene scene) {
        Effects effects = Effects.of(scene);
        return (int) Effect.ALL.stream().filter(effect -> canMeasure(effect, effects)).count();
    }

    private static boolean canMeasure(Effect effect, Effects effects) {
        return effects.has(effect) || effect.isForcible();
    }
}
