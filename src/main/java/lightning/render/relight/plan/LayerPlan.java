package lightning.render.relight.plan;

import lightning.render.cache.KnownLight;
import lightning.render.cache.LayerStamp;
import lightning.render.trace.ShapeChange;
import lightning.scene.Light;
import lightning.scene.Links;

/**
 * The update of one light's layer.
 *
 * @param light  the light as wanted
 * @param from   the light known before that it goes on from, null for none
 * @param update what to do
 * @param shadows what became of the shapes that throw shadows in its light
 */
public record LayerPlan(Light light, KnownLight from, LightUpdate update, ShapeChange shadows) {
    /** One that is shadowed as before. */
    public LayerPlan(Light light, KnownLight from, LightUpdate update) {
        this(light, from, update, ShapeChange.NONE);
    }

    /** What the layers there are were computed for, or null where there are none. */
    public LayerStamp before() {
        return from == null ? null : from.stamp();
    }

    /**
     * Which shapes throw shadows in the light as its layer shows it afterwards, where the update goes on from one.
     *
     * @param before what the layers there are were computed for
     */
    public static Links shadowedBy(Light light, LayerStamp before, LightUpdate update) {
        return update instanceof LightUpdate.Keep ? before.light().shadowedBy() : light.shadowedBy();
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
