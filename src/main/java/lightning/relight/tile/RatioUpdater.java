package lightning.relight.tile;

import lightning.relight.plan.LightUpdate;
import lightning.shading.ConeChange;
import lightning.shading.Lamp;
import lightning.shading.LightLayer;
import lightning.shading.LightRows;
import lightning.shading.RatioKernel;
import lightning.shading.RatioRows;
import lightning.trace.HitRows;
import lightning.trace.MaterialSet;
import lightning.trace.RowSplice;

/** The paper's updates: stored contributions are scaled by ratios (§4.1 to §4.4). */
record RatioUpdater(RatioKernel kernel) implements LayerUpdater {

    @Override
    public LightLayer full(HitRows rows, Lamp lamp) {
        return kernel.full(rows, lamp);
    }

    @Override
    public LightLayer update(HitRows rows, Lamp from, Lamp to, LightLayer before, LightUpdate update) {
        return switch (update) {
            case LightUpdate.Keep _ -> before;
            case LightUpdate.Refresh _ -> kernel.again(rows, to, (RatioRows) before);
            case LightUpdate.Reweight _ -> kernel.partial(rows, from, to, (RatioRows) before, ConeChange.NONE, false);
            case LightUpdate.FullRecompute _ -> full(rows, to);
            case LightUpdate.Partial p -> kernel.partial(rows, from, to, (RatioRows) before, p.cone(), p.falloff());
        };
    }

    @Override
    public LightLayer convert(HitRows rows, Lamp lamp, LightLayer before) {
        return switch (before) {
            case LightRows layer -> kernel.of(rows, lamp, layer);
            case RatioRows layer -> layer;
        };
    }

    @Override
    public LightLayer speculars(HitRows rows, Lamp lamp, LightLayer before, MaterialSet changed) {
        return kernel.speculars(rows, lamp, (RatioRows) before, changed);
    }

    @Override
    public LightLayer spliced(RowSplice splice, LightLayer before, LightLayer added, Lamp lamp) {
        return kernel.spliced(splice, (RatioRows) before, (RatioRows) added);
    }
}
