package lightning.relight;

import lightning.shading.Lamp;
import lightning.shading.LightLayer;
import lightning.trace.HitRows;

/** Carries out a light's update on one tile's layer, at one level of accuracy. One for each thread. */
interface LayerUpdater {
    /** A layer from nothing. */
    LightLayer full(HitRows rows, Lamp lamp);

    /**
     * The layer after an update.
     *
     * @param before what it was, or null
     * @param from   the light that it was computed for, or null
     */
    LightLayer update(HitRows rows, Lamp from, Lamp to, LightLayer before, LightUpdate update);
}
