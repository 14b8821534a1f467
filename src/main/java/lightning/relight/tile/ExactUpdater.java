package lightning.relight.tile;

import lightning.relight.plan.LightUpdate;
import lightning.shading.Columns;
import lightning.shading.LightKernel;
import lightning.shading.LightLayer;
import lightning.shading.LightRows;
import lightning.shading.Luminaire;
import lightning.shading.RatioRows;
import lightning.trace.HitRows;
import lightning.trace.MaterialSet;
import lightning.trace.RowSplice;
import lightning.trace.ShapeChange;

/** Updates that leave a layer as a full trace would make it, in every bit of its terms, and compact. */
record ExactUpdater(LightKernel kernel) implements LayerUpdater {

    @Override
    public LightLayer full(HitRows rows, Luminaire light) {
        return kernel.full(rows, light.lamp(), Columns.FRESH).compact(rows.count);
    }

    @Override
    public LightLayer update(HitRows rows, Luminaire from, Luminaire to, LightLayer before, LightUpdate update) {
        return switch (update) {
            case LightUpdate.Keep _,LightUpdate.Reweight _,LightUpdate.Refresh _ -> before;
            case LightUpdate.FullRecompute _ -> full(rows, to);
            case LightUpdate.Partial p ->
                    kernel.partial(rows, to.lamp(), (LightRows) before, p.cone(), p.falloff(), Columns.FRESH).compact(rows.count);
        };
    }

    @Override
    public LightLayer convert(HitRows rows, Luminaire light, LightLayer before) {
        return switch (before) {
            case LightRows layer -> layer;
            case RatioRows layer -> kernel.again(rows, light.lamp(), layer, Columns.FRESH).compact(rows.count);
        };
    }

    @Override
    public LightLayer speculars(HitRows rows, Luminaire light, LightLayer before, MaterialSet changed) {
        return kernel.speculars(rows, light.lamp(), (LightRows) before, changed, Columns.FRESH).compact(rows.count);
    }

    @Override
    public LightLayer shadowed(HitRows rows, Luminaire light, LightLayer before, ShapeChange change) {
        return kernel.shadowed(rows, light.lamp(), (LightRows) before, change, Columns.FRESH).compact(rows.count);
    }

    @Override
    public boolean mayChange(HitRows rows, Luminaire light, LightLayer before, ShapeChange change) {
        return kernel.mayChange(rows, light.lamp(), before, change);
    }

    @Override
    public LightLayer sorted(RowSplice splice, LightLayer before) {
        return kernel.sorted(splice, (LightRows) before).compact(splice.rows().count);
    }

    @Override
    public LightLayer joined(RowSplice splice, LightLayer before, LightLayer added, Luminaire light) {
        return kernel.joined(splice, (LightRows) before, (LightRows) added, light.lamp()).compact(splice.rows().count);
    }
}
