package lightning.bench;

import java.util.List;
import lightning.bench.accuracy.EffectCost;

/**
 * What an effect takes on a scene, or what its absence saves there; see {@link EffectCost}.
 *
 * @param effect   for people, as in {@code shadows}
 * @param inUse    whether the scene calls for it
 * @param callers  who calls for it
 * @param firstMs  by how much it makes the first pass longer, milliseconds
 * @param updateMs by how much it makes the update after an edit longer, milliseconds
 * @param noiseMs  how far the first pass's times scatter: half the distance between their quartiles, with it or without it, the larger
 * @param updateNoiseMs likewise of the update's times
 * @param bytes    by how much it makes the kept picture larger
 * @param rays     how many more rays the first pass casts
 */
public record EffectResult(String effect, boolean inUse, List<String> callers, double firstMs, double updateMs, double noiseMs,
        double updateNoiseMs,
        long bytes, long rays) {
    public EffectResult {
        callers = List.copyOf(callers);
    }

    /** By how much it makes the first pass longer; NaN where that is no more than the times scatter. */
    public double certainFirstMs() {
        return Math.abs(firstMs) > noiseMs ? firstMs : Double.NaN;
    }

    /** By how much it makes the update longer; NaN where that is no more than the times scatter. */
    public double certainUpdateMs() {
        return Math.abs(updateMs) > updateNoiseMs ? updateMs : Double.NaN;
    }

    static EffectResult of(EffectCost cost) {
        return new EffectResult(cost.effect().title(), cost.inUse(), cost.callers(), cost.firstMs(), cost.updateMs(), cost.firstNoise(),
                cost.updateNoise(),
                cost.bytes(), cost.rays().total());
    }
}
