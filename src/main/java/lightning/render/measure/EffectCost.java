package lightning.render.measure;

import java.util.List;
import lightning.render.shading.RayCounts;
import lightning.scene.effects.RenderEffect;

/**
 * Cost of an effect, measured by rendering with and without it in turns. If the scene uses it, it is hidden. Otherwise it is forced on, and
 * the values are the savings from its absence.
 *
 * @param callers     names of the lights, materials or shapes that use it, in scene order; empty if none
 * @param measured    whether it was measured; an absent kind of light or shape cannot be forced on, and anti-aliasing samples may exceed
 *         memory
 * @param firstMs     added time of the first pass, milliseconds; negative by noise, or if a scene without it has more work
 * @param updateMs    added time of the update after an edit, as {@code firstMs}
 * @param firstNoise  half the interquartile range of the first passes with or without it, whichever is larger, milliseconds
 * @param updateNoise noise of the updates, as {@code firstNoise}
 * @param bytes       added bytes of the cache; negative if other columns are needed without it
 * @param rays        added rays of the first pass
 */
public record EffectCost(RenderEffect effect, List<String> callers, boolean measured, double firstMs, double updateMs, double firstNoise,
        double updateNoise, long bytes, RayCounts rays) {
    public EffectCost {
        callers = List.copyOf(callers);
    }

    /** Returns whether the scene uses it. */
    public boolean inUse() {
        return !callers.isEmpty();
    }
}
