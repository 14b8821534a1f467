package lightning.relight.tile;

import lightning.relight.plan.Accuracy;
import lightning.relight.plan.LightUpdate;
import lightning.shading.Lamp;
import lightning.shading.LightKernel;
import lightning.shading.LightLayer;
import lightning.shading.RatioKernel;
import lightning.trace.HitRows;
import lightning.trace.MaterialSet;
import lightning.trace.RowSplice;

/** Carries out a light's update on one tile's layer, at one level of accuracy. One for each thread. */
public interface LayerUpdater {
    /** The one of a level. */
    static LayerUpdater of(Accuracy accuracy, LightKernel lights, RatioKernel ratios) {
        return switch (accuracy) {
            case EXACT -> new ExactUpdater(lights);
            case RATIO -> new RatioUpdater(ratios);
        };
    }

    /** A layer from nothing. */
    LightLayer full(HitRows rows, Lamp lamp);

    /**
     * The layer after an update.
     *
     * @param before what it was, or null
     * @param from   the light that it was computed for, or null
     */
    LightLayer update(HitRows rows, Lamp from, Lamp to, LightLayer before, LightUpdate update);

    /** The layer in this level's form, as {@link #full} would make it, from one in either form; no ray is cast. */
    LightLayer convert(HitRows rows, Lamp lamp, LightLayer before);

    /**
     * The layer after an edit of materials, its light being as it was.
     *
     * @param lamp    the light that it was computed for
     * @param changed materials whose specular term changed
     */
    LightLayer speculars(HitRows rows, Lamp lamp, LightLayer before, MaterialSet changed);

    /**
     * The layer over rows that were put together anew.
     *
     * @param before over the old rows
     * @param added  over the added rows; null where there are none
     * @param lamp   the light that both were computed for; unread where no rows were added
     */
    LightLayer spliced(RowSplice splice, LightLayer before, LightLayer added, Lamp lamp);
}
