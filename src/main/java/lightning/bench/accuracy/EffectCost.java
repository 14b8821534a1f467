package lightning.bench.accuracy;

import java.util.List;
import lightning.render.shading.RayCounts;
import lightning.scene.effects.RenderEffect;

/**
 * What an effect takes, found by rendering with it and without it in turns: where the scene calls for it, by hiding it;
 * where it does not, by forcing it on, and then these are what its absence saves.
 *
 * @param callers    the names of the lights, materials or shapes that call for it, in the order of the scene; empty where
 *                   nobody does
 * @param measured   whether it was: an absent kind of light or shape has nothing that could be forced on, and finer
 *                   samples may need more memory than there is
 * @param firstMs    by how much it makes the first pass longer, milliseconds; below 0 only by noise, or where a scene without
 *                   it has more to do
 * @param updateMs   likewise the update after an edit
 * @param firstNoise half the distance between the quartiles of the first passes with it or without it, the larger, milliseconds
 * @param updateNoise likewise of the updates
 * @param bytes      by how much it makes the picture's cache larger; below 0 where other columns are needed without it
 * @param rays       how many more rays the first pass casts
 */
public record EffectCost(RenderEffect effect, List<String> callers, boolean measured, double firstMs, double updateMs, double firstNoise,
        double updateNoise, long bytes, RayCounts rays) {
    public EffectCost {
        callers = List.copyOf(callers);
    }

    /** Whether the scene calls for it. */
    public boolean inUse() {
        return !callers.isEmpty();
    }
}
