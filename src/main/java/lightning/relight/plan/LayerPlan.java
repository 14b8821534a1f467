package lightning.relight.plan;

import lightning.cache.LayerStamp;
import lightning.scene.Light;

/**
 * The update of one light's layer.
 *
 * @param light  the light as wanted
 * @param from   which layer of the old cache it goes on from, −1 for none
 * @param before what the old layer shows, null for none
 * @param update what to do
 */
public record LayerPlan(Light light, int from, LayerStamp before, LightUpdate update) {
    /**
     * What the layer shows afterwards, or null if there is none.
     *
     * @param scaled       whether the update is carried out by ratios
     * @param leastFalloff the least falloff of rows whose falloff was scaled
     */
    public LayerStamp stamp(boolean scaled, double leastFalloff) {
        return switch (update) {
            case LightUpdate.Keep _ -> before;
            case LightUpdate.FullRecompute _,LightUpdate.Refresh _ -> LayerStamp.fresh(light);
            case LightUpdate.Reweight _ -> scaled ? RatioBound.scaled(before, light, true, false, leastFalloff) : LayerStamp.fresh(light);
            case LightUpdate.Partial p -> scaled
                    ? RatioBound.scaled(before, light, p.weight(), p.falloff(), leastFalloff)
                    : LayerStamp.fresh(light);
        };
    }
}
