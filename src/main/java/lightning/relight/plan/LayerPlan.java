package lightning.relight.plan;

import lightning.cache.KnownLight;
import lightning.cache.LayerStamp;
import lightning.scene.Light;

/**
 * The update of one light's layer.
 *
 * @param light  the light as wanted
 * @param from   the light known before that it goes on from, null for none
 * @param update what to do
 */
public record LayerPlan(Light light, KnownLight from, LightUpdate update) {
    /** What the layers there are were computed for, or null where there are none. */
    public LayerStamp before() {
        return from == null ? null : from.stamp();
    }

    /**
     * What the layer shows afterwards, or null if there is none.
     *
     * @param scaled       whether the update is carried out by ratios
     * @param leastFalloff the least falloff of rows whose falloff was scaled
     */
    public LayerStamp stamp(boolean scaled, double leastFalloff) {
        return switch (update) {
            case LightUpdate.Keep _ -> before();
            case LightUpdate.FullRecompute _,LightUpdate.Refresh _ -> LayerStamp.fresh(light);
            case LightUpdate.Reweight _ -> scaled ? RatioBound.scaled(before(), light, true, false, leastFalloff) : LayerStamp.fresh(light);
            case LightUpdate.Partial p -> scaled
                    ? RatioBound.scaled(before(), light, p.weight(), p.falloff(), leastFalloff)
                    : LayerStamp.fresh(light);
        };
    }
}
