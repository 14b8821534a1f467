package lightning.render.relight.tile;

import lightning.render.relight.plan.LayerPlan;
import lightning.render.relight.plan.LayerUpdater;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.shading.Columns;
import lightning.render.shading.LightKernel;
import lightning.render.shading.LightLayer;
import lightning.render.shading.LightRows;
import lightning.render.shading.Luminaire;
import lightning.render.shading.ScratchColumns;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.RowSplice;

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
    public LightLayer update(HitRows rows, LightLayer before, LayerPlan plan, MaterialSet speculars) {
        LightRows known = (LightRows) before;
        LightRows layer = kept(known, kernel.speculars(rows, plan.computed().lamp(), known, speculars, Columns.FRESH), rows);
        if (!plan.shadows().isEmpty()) {
            layer = kept(layer, kernel.shadowed(rows, plan.computed().lamp(), layer, plan.shadows(), Columns.FRESH), rows);
        }
        return switch (plan.update()) {
            case LightUpdate.Keep _,LightUpdate.Reweight _,LightUpdate.Refresh _ -> layer;
            case LightUpdate.FullRecompute _ -> full(rows, plan.wanted());
            case LightUpdate.Partial p ->
                    kept(layer, kernel.partial(rows, plan.wanted().lamp(), layer, p.cone(), p.falloff(), Columns.FRESH), rows);
        };
    }

    @Override
    public LightLayer convert(HitRows rows, Luminaire light, LightLayer before) {
        return before instanceof LightRows ? before : kept(null, kernel.again(rows, light.lamp(), before, Columns.FRESH), rows);
    }

    @Override
    public LightLayer sorted(RowSplice splice, LightLayer before) {
        return kept(null, kernel.sorted(splice, (LightRows) before), splice.rows());
    }

    @Override
    public LightLayer joined(RowSplice splice, LightLayer before, LightLayer added, Luminaire light) {
        return kept(null, kernel.joined(splice, (LightRows) before, (LightRows) added, light.lamp()), splice.rows());
    }

    @Override
    public LightRows terms(HitRows rows, Luminaire light, LightLayer layer) {
        return (LightRows) layer;
    }

    @Override
    public long rowsTouched() {
        return kernel.rowsTouched();
    }

    @Override
    public double leastFalloff() {
        return 1;
    }

    /**
     * A layer without what need not be kept. One that an edit leaves as it was is so already: its columns are not looked over again, which an edit of
     * one light would else do with those of all others.
     */
    private static LightRows kept(LightRows before, LightRows after, HitRows rows) {
        return after == before ? after : after.compact(rows.count);
    }
}
