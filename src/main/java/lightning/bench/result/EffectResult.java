package lightning.bench.result;

import java.util.List;
import lightning.render.measure.EffectCost;

/**
 * Cost of an effect on a scene, or saving from its absence; see {@link EffectCost}.
 *
 * @param effect        name for people, as in {@code shadows}
 * @param inUse         whether the scene uses it
 * @param callers       names of lights, materials or shapes that use it
 * @param firstMs       added time of the first pass, milliseconds
 * @param updateMs      added time of the update after an edit, milliseconds
 * @param noiseMs       noise of the first pass: half the interquartile range with or without the effect, whichever is larger
 * @param updateNoiseMs noise of the update, as {@code noiseMs}
 * @param bytes         added bytes of the image's cache
 * @param rays          added rays of the first pass
 */
public record EffectResult(String effect, boolean inUse, List<String> callers, double firstMs, double updateMs, double noiseMs,
        double updateNoiseMs,
        long bytes, long rays) {
    public EffectResult {
        callers = List.copyOf(callers);
    }

    /** Returns the added time of the first pass; NaN if it does not exceed the noise. */
    public double certainFirstMs() {
        return Math.abs(firstMs) > noiseMs ? firstMs : Double.NaN;
    }

    /** Returns the added time of the update; NaN if it does not exceed the noise. */
    public double certainUpdateMs() {
        return Math.abs(updateMs) > updateNoiseMs ? updateMs : Double.NaN;
    }

    public static EffectResult of(EffectCost cost) {
        return new EffectResult(cost.effect().title(), cost.inUse(), cost.callers(), cost.firstMs(), cost.updateMs(), cost.firstNoise(),
                cost.updateNoise(),
                cost.bytes(), cost.rays().total());
    }
}
