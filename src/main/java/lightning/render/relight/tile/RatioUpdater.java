package lightning.render.relight.tile;

import lightning.render.relight.plan.LightUpdate;
import lightning.render.shading.ConeChange;
import lightning.render.shading.LightLayer;
import lightning.render.shading.LightRows;
import lightning.render.shading.Luminaire;
import lightning.render.shading.RatioKernel;
import lightning.render.shading.RatioRows;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.RowSplice;
import lightning.render.trace.ShapeChange;

/** The paper's updates: stored contributions are scaled by ratios (§4.1 to §4.4). */
record RatioUpdater(RatioKernel kernel) implements LayerUpdater {

    @Override
    public LightLayer full(HitRows rows, Luminaire light) {
        return kernel.full(rows, light);
    }

    @Override
    public LightLayer update(HitRows rows, Luminaire from, Luminaire to, LightLayer before, LightUpdate update) {
        return switch (update) {
            case LightUpdate.Keep _ -> before;
            case LightUpdate.Refresh _ -> kernel.again(rows, to, (RatioRows) before);
            case LightUpdate.Reweight _ -> kernel.partial(rows, from, to, (RatioRows) before, ConeChange.NONE, false);
            case LightUpdate.FullRecompute _ -> full(rows, to);
            case LightUpdate.Partial p -> kernel.partial(rows, from, to, (RatioRows) before, p.cone(), p.falloff());
        };
    }

    @Override
    public LightLayer convert(HitRows rows, Luminaire light, LightLayer before) {
        return switch (before) {
            case LightRows layer -> kernel.of(rows, light, layer);
            case RatioRows layer -> layer;
        };
    }

    @Override
    public LightLayer speculars(HitRows rows, Luminaire light, LightLayer before, MaterialSet changed) {
        return kernel.speculars(rows, light, (RatioRows) before, changed);
    }

    @Override
    public LightLayer shadowed(HitRows rows, Luminaire light, LightLayer before, ShapeChange change) {
        return kernel.shadowed(rows, light, (RatioRows) before, change);
    }

    @Override
    public boolean mayChange(HitRows rows, Luminaire light, LightLayer before, ShapeChange change) {
        return kernel.exact().mayChange(rows, light.lamp(), before, change);
    }

    @Override
    public LightLayer sorted(RowSplice splice, LightLayer before) {
        return kernel.spliced(splice, (RatioRows) before, null);
    }

    @Override
    public LightLayer joined(RowSplice splice, LightLayer before, LightLayer added, Luminaire light) {
        return kernel.spliced(splice, (RatioRows) before, (RatioRows) added);
    }
}
