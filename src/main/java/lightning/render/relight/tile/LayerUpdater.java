package lightning.render.relight.tile;

import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.shading.LightKernel;
import lightning.render.shading.LightLayer;
import lightning.render.shading.Luminaire;
import lightning.render.shading.RatioKernel;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.RowSplice;
import lightning.render.trace.ShapeChange;

/** Carries out a light's update on one tile's layer, at one accuracy. One for each thread. */
public interface LayerUpdater {
    /**
     * The one of an accuracy.
     *
     * @param count how many lights there are
     */
    static LayerUpdater of(Accuracy accuracy, LightKernel lights, RatioKernel ratios, int count) {
        return switch (accuracy) {
            case EXACT -> new ExactUpdater(lights, count >= RepeatedEdit.LEAST_LIGHTS);
            case RATIO -> new RatioUpdater(ratios);
        };
    }

    /** A layer from nothing. */
    LightLayer full(HitRows rows, Luminaire light);

    /**
     * The layer after an update.
     *
     * @param before what it was, or null
     * @param from   the light that it was computed for, or null
     */
    LightLayer update(HitRows rows, Luminaire from, Luminaire to, LightLayer before, LightUpdate update);

    /** The layer in this accuracy's form, as {@link #full} would make it, from one in either form; no ray is cast. */
    LightLayer convert(HitRows rows, Luminaire light, LightLayer before);

    /**
     * The layer after an edit of materials, its light being as it was.
     *
     * @param light   the light that it was computed for
     * @param changed materials whose specular term changed
     */
    LightLayer speculars(HitRows rows, Luminaire light, LightLayer before, MaterialSet changed);

    /**
     * The layer after other shapes, its light being as it was: of the rows that were asked, those are asked again whose way to the
     * light may meet what came or what is gone.
     *
     * @param light the light that it was computed for
     */
    LightLayer shadowed(HitRows rows, Luminaire light, LightLayer before, ShapeChange change);

    /** Whether {@link #shadowed} would ask any row. */
    boolean mayChange(HitRows rows, Luminaire light, LightLayer before, ShapeChange change);

    /** The layer over rows of which some may be gone, in another order; {@code before} is over the old rows. */
    LightLayer sorted(RowSplice splice, LightLayer before);

    /**
     * The layer over rows that were put together of old ones and others.
     *
     * @param before over the old rows
     * @param added  over the added rows
     * @param light  the light that both were computed for
     */
    LightLayer joined(RowSplice splice, LightLayer before, LightLayer added, Luminaire light);
}
