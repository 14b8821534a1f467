package lightning.render.relight.paper;

import lightning.render.relight.plan.LayerPlan;
import lightning.render.relight.plan.LayerUpdater;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.shading.ConeChange;
import lightning.render.shading.LightLayer;
import lightning.render.shading.LightRows;
import lightning.render.shading.Luminaire;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.RowSplice;

/** The paper's updates: stored contributions are scaled by ratios (§4.1 to §4.4). */
record RatioUpdater(RatioKernel kernel) implements LayerUpdater {

    @Override
    public LightLayer full(HitRows rows, Luminaire light) {
        return kernel.full(rows, light);
    }

    @Override
    public LightLayer update(HitRows rows, LightLayer before, LayerPlan plan, MaterialSet speculars) {
        Luminaire from = plan.computed();
        Luminaire to = plan.wanted();
        RatioRows layer = kernel.speculars(rows, from, (RatioRows) before, speculars);
        layer = plan.shadows().isEmpty() ? layer : kernel.shadowed(rows, from, layer, plan.shadows());
        return switch (plan.update()) {
            case LightUpdate.Keep _ -> layer;
            case LightUpdate.Refresh _ -> kernel.again(rows, to, layer);
            case LightUpdate.Reweight _ -> kernel.partial(rows, from, to, layer, ConeChange.NONE, false);
            case LightUpdate.FullRecompute _ -> full(rows, to);
            case LightUpdate.Partial p -> kernel.partial(rows, from, to, layer, p.cone(), p.falloff());
        };
    }

    @Override
    public LightLayer convert(HitRows rows, Luminaire light, LightLayer before) {
        return before instanceof LightRows layer ? kernel.of(rows, light, layer) : before;
    }

    @Override
    public LightLayer sorted(RowSplice splice, LightLayer before) {
        return kernel.spliced(splice, (RatioRows) before, null);
    }

    @Override
    public LightLayer joined(RowSplice splice, LightLayer before, LightLayer added, Luminaire light) {
        return kernel.spliced(splice, (RatioRows) before, (RatioRows) added);
    }

    @Override
    public LightRows terms(HitRows rows, Luminaire light, LightLayer layer) {
        return kernel.terms(rows, light, (RatioRows) layer);
    }

    @Override
    public long rowsTouched() {
        return kernel.rowsTouched();
    }

    @Override
    public double leastFalloff() {
        return kernel.leastFalloff();
    }
}
