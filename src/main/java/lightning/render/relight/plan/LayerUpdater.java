package lightning.render.relight.plan;

import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.LightLayer;
import lightning.render.shading.layer.LightRows;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.RowSplice;

/** Applies a light's update to one tile's layer, by one method. Use one instance per thread. */
public interface LayerUpdater {
    /** Computes a layer from nothing. */
    LightLayer recompute(HitRows rows, WeightedLight light);

    /**
     * Returns the updated layer: first for materials and shapes with the old light, then for the light.
     *
     * @param speculars materials whose specular term changed
     */
    LightLayer update(HitRows rows, LightLayer before, LayerPlan plan, MaterialSet speculars);

    /** Converts a layer of any accuracy to this method's form, as {@link #recompute} would compute it. Casts no ray. */
    LightLayer convert(HitRows rows, WeightedLight light, LightLayer before);

    /** Returns the layer for reordered rows, some of which may be removed; {@code before} covers the old rows. */
    LightLayer reorder(RowSplice splice, LightLayer before);

    /**
     * Returns the layer for rows spliced from old and added ones.
     *
     * @param before layer of the old rows
     * @param added  layer of the added rows
     * @param light  the light that both were computed for
     */
    LightLayer join(RowSplice splice, LightLayer before, LightLayer added, WeightedLight light);

    /** Returns the terms of a layer. Casts no ray. */
    LightRows terms(HitRows rows, WeightedLight light, LightLayer layer);

    /** Returns the number of layer rows tested or written since the start. */
    long rowsTouched();

    /** Returns the smallest falloff, before or after, of rows whose falloff was scaled since the start; 1 if there were none. */
    double minFalloff();
}
