package lightning.render.relight.paper;

import lightning.render.cache.LayerStamp;
import lightning.scene.Light;

/**
 * What a layer shows whose contributions were scaled, and what that may have lost.
 *
 * @param light     the light that it shows
 * @param roundings how many float roundings lie between a contribution and its exact value, beyond
 *                  those of the equation itself
 * @param contributionLoss how far a contribution may be off because values underflowed before the last scaling of
 *                           falloffs, as a share of its light's weight times its falloff
 * @param weightLoss       the same for values that underflowed since, as a share of its light's weight
 */
record ScaledStamp(Light light, int roundings, double contributionLoss, double weightLoss) implements LayerStamp {

    /** What a layer has lost so far; nothing where it was not scaled. */
    static ScaledStamp of(LayerStamp stamp) {
        return stamp instanceof ScaledStamp scaled ? scaled : new ScaledStamp(stamp.light(), 0, 0, 0);
    }
}
