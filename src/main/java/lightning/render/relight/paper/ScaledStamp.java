package lightning.render.relight.paper;

import lightning.render.cache.LayerStamp;
import lightning.render.fog.FogMedium;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;

/**
 * Stamp of a layer whose contributions were scaled, with the bounds of their losses.
 *
 * @param light            the light that the layer shows
 * @param fog              fog that dims it
 * @param roundings        number of float roundings between a contribution and its exact value, beyond those of the equation itself
 * @param contributionLoss largest error of a contribution by underflow before the last scaling of falloffs, as a share of its
 *                         light's weight times its falloff
 * @param weightLoss       largest error by underflow since then, as a share of its light's weight
 */
record ScaledStamp(Light light, @Nullable FogMedium fog, int roundings, double contributionLoss, double weightLoss)
        implements LayerStamp {

    /** Creates a stamp in clear air. */
    ScaledStamp(Light light, int roundings, double contributionLoss, double weightLoss) {
        this(light, null, roundings, contributionLoss, weightLoss);
    }

    ScaledStamp withFog(@Nullable FogMedium v) {
        return new ScaledStamp(light, v, roundings, contributionLoss, weightLoss);
    }

    /** Returns the losses of a layer so far; none if it was not scaled. */
    static ScaledStamp of(LayerStamp stamp) {
        return stamp instanceof ScaledStamp scaled ? scaled : new ScaledStamp(stamp.light(), stamp.fog(), 0, 0, 0);
    }
}
