package lightning.render.relight.tile;

import lightning.render.relight.plan.LightUpdate;
import lightning.render.shading.Columns;
import lightning.render.shading.LightKernel;
import lightning.render.shading.LightLayer;
import lightning.render.shading.LightRows;
import lightning.render.shading.Luminaire;
import lightning.render.shading.RatioRows;
import lightning.render.shading.ScratchColumns;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.RowSplice;
import lightning.render.trace.ShapeChange;

/** Updates that leave a layer as a full trace would make it, in every bit of its terms, and compact. */
record ExactUpdater(LightKernel kernel, boolean fades, ScratchColumns scratch) implements LayerUpdater {

    /** @param fades whether layers made from nothing keep cosine times falloff, where they have no highlight */
    ExactUpdater(LightKernel kernel, boolean fades) {
        this(kernel, fades, new ScratchColumns());
    }

    /** Made in scratch columns, so that new memory is taken for what is kept alone. */
    @Override
    public LightLayer full(HitRows rows, Luminaire light) {
        scratch.reset();
        LightRows layer = kernel.full(rows, light.lamp(), scratch);
        return (fades ? layer.faded(rows.count) : layer).copied(rows.count);
    }

    @Override
    public LightLayer update(HitRows rows, Luminaire from, Luminaire to, LightLayer before, LightUpdate update) {
        return switch (update) {
            case LightUpdate.Keep _,LightUpdate.Reweight _,LightUpdate.Refresh _ -> before;
            case LightUpdate.FullRecompute _ -> full(rows, to);
            case LightUpdate.Partial p ->
                    kept(before, kernel.partial(rows, to.lamp(), (LightRows) before, p.cone(), p.falloff(), Columns.FRESH), rows);
        };
    }

    @Override
    public LightLayer convert(HitRows rows, Luminaire light, LightLayer before) {
        return switch (before) {
            case LightRows layer -> layer;
            case RatioRows layer -> kept(null, kernel.again(rows, light.lamp(), layer, Columns.FRESH), rows);
        };
    }

    @Override
    public LightLayer speculars(HitRows rows, Luminaire light, LightLayer before, MaterialSet changed) {
        return kept(before, kernel.speculars(rows, light.lamp(), (LightRows) before, changed, Columns.FRESH), rows);
    }

    @Override
    public LightLayer shadowed(HitRows rows, Luminaire light, LightLayer before, ShapeChange change) {
        return kept(before, kernel.shadowed(rows, light.lamp(), (LightRows) before, change, Columns.FRESH), rows);
    }

    @Override
    public boolean mayChange(HitRows rows, Luminaire light, LightLayer before, ShapeChange change) {
        return kernel.mayChange(rows, light.lamp(), before, change);
    }

    @Override
    public LightLayer sorted(RowSplice splice, LightLayer before) {
        return kept(null, kernel.sorted(splice, (LightRows) before), splice.rows());
    }

    @Override
    public LightLayer joined(RowSplice splice, LightLayer before, LightLayer added, Luminaire light) {
        return kept(null, kernel.joined(splice, (LightRows) before, (LightRows) added, light.lamp()), splice.rows());
    }

    /**
     * A layer without what need not be kept. One that an edit leaves as it was is so already: its columns are not looked over again, which an edit of
     * one light would else do with those of all others.
     */
    private static LightRows kept(LightLayer before, LightRows after, HitRows rows) {
        return after == before ? after : after.compact(rows.count);
    }
}
