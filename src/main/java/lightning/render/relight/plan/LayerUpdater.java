package lightning.render.relight.plan;

import lightning.render.shading.LightLayer;
import lightning.render.shading.LightRows;
import lightning.render.shading.WeightedLight;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.RowSplice;

/** Carries out a light's update on one tile's layer, by one method. One for each thread. */
public interface LayerUpdater {
    /** A layer from nothing. */
    LightLayer recompute(HitRows rows, WeightedLight light);

    /**
     * The layer after an update that goes on from one: first for materials and shapes, its light being as it was, then for the light.
     *
     * @param speculars materials whose specular term changed
     */
    LightLayer update(HitRows rows, LightLayer before, LayerPlan plan, MaterialSet speculars);

    /** The layer in this method's form, as {@link #recompute} would make it, from one in any form; no ray is cast. */
    LightLayer convert(HitRows rows, WeightedLight light, LightLayer before);

    /** The layer over rows of which some may be gone, in another order; {@code before} is over the old rows. */
    LightLayer reorder(RowSplice splice, LightLayer before);

    /**
     * The layer over rows that were put together of old ones and others.
     *
     * @param before over the old rows
     * @param added  over the added rows
     * @param light  the light that both were computed for
     */
    LightLayer join(RowSplice splice, LightLayer before, LightLayer added, WeightedLight light);

    /** The terms that a layer stands for: valid until the next call, and without a ray. */
    LightRows terms(HitRows rows, WeightedLight light, LightLayer layer);

    /** Rows of layers that were looked at or written since the start. */
    long rowsTouched();

    /** The least falloff, before or after, of rows whose falloff was scaled since the start; 1 where none was. */
    double minFalloff();
}
