package lightning.render.cache;

import lightning.scene.Light;

/**
 * What a layer shows.
 *
 * @param light     the light that it was computed for
 * @param roundings how many float roundings lie between a contribution and its exact value, beyond
 *                  those of the equation itself; 0 where contributions were computed and not scaled
 * @param lostOfContribution how far a contribution may be off because values underflowed before the last scaling of
 *                           falloffs, as a share of its light's weight times its falloff
 * @param lostOfWeight       the same for values that underflowed since, as a share of its light's weight
 */
public record LayerStamp(Light light, int roundings, double lostOfContribution, double lostOfWeight) {
    /** A layer that was just computed. */
    public static LayerStamp fresh(Light light) {
        return new LayerStamp(light, 0, 0, 0);
    }
}
