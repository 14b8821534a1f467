package lightning.bench;

import java.util.List;
import lightning.accuracy.EffectCost;

/**
 * What an effect takes on a scene, or what its absence saves there; see {@link EffectCost}.
 *
 * @param effect   for people, as in {@code shadows}
 * @param inUse    whether the scene calls for it
 * @param callers  who calls for it
 * @param firstMs  by how much it makes the first pass longer, milliseconds
 * @param updateMs by how much it makes the update after an edit longer, milliseconds
 * @param noiseMs  half the distance between the quartiles of the first pass with it, milliseconds
 * @param bytes    by how much it makes the kept picture larger
 * @param rays     how many more rays the first pass casts
 */
public record EffectResult(String effect, boolean inUse, List<String> callers, double firstMs, double updateMs, double noiseMs,
        long bytes, long rays) {
    public EffectResult {
        callers = List.copyOf(callers);
    }

    static EffectResult of(EffectCost cost) {
        return new EffectResult(cost.effect().title(), cost.inUse(), cost.callers(), cost.firstMs(), cost.updateMs(), cost.firstNoise(),
                cost.bytes(), cost.rays().all());
    }
}
