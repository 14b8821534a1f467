package lightning.relight.tile;

import lightning.relight.plan.LightUpdate;
import lightning.shading.Columns;
import lightning.shading.Lamp;
import lightning.shading.LightKernel;
import lightning.shading.LightLayer;
import lightning.shading.LightRows;
import lightning.shading.RatioRows;
import lightning.trace.HitRows;
import lightning.trace.MaterialSet;
import lightning.trace.RowSplice;

/** Updates that leave a layer as a full trace would make it, in every bit. */
record ExactUpdater(LightKernel kernel) implements LayerUpdater {

    @Override
    public LightLayer full(HitRows rows, Lamp lamp) {
        return kernel.full(rows, lamp, Columns.FRESH);
    }

    @Override
    public LightLayer update(HitRows rows, Lamp from, Lamp to, LightLayer before, LightUpdate update) {
        return switch (update) {
            case LightUpdate.Keep _,LightUpdate.Reweight _,LightUpdate.Refresh _ -> before;
            case LightUpdate.FullRecompute _ -> full(rows, to);
            case LightUpdate.Partial p ->
                    kernel.partial(rows, to, (LightRows) before, p.cone(), p.falloff(), Columns.FRESH);
        };
    }

    @Override
    public LightLayer convert(HitRows rows, Lamp lamp, LightLayer before) {
        return switch (before) {
            case LightRows layer -> layer;
            case RatioRows layer -> kernel.again(rows, lamp, layer, Columns.FRESH);
        };
    }

    @Override
    public LightLayer speculars(HitRows rows, Lamp lamp, LightLayer before, MaterialSet changed) {
        return kernel.speculars(rows, lamp, (LightRows) before, changed, Columns.FRESH);
    }

    @Override
    public LightLayer spliced(RowSplice splice, LightLayer before, LightLayer added, Lamp lamp) {
        return kernel.spliced(splice, (LightRows) before, (LightRows) added, lamp);
    }
}
