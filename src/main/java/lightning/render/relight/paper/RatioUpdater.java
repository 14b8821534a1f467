package lightning.render.relight.paper;

import static java.util.Objects.requireNonNull;

import lightning.render.relight.plan.LayerPlan;
import lightning.render.relight.plan.LayerUpdater;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.ConeChange;
import lightning.render.shading.layer.LightLayer;
import lightning.render.shading.layer.LightRows;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.RowSplice;

/** The paper's updates: stored contributions are scaled by ratios (§4.1 to §4.4). */
record RatioUpdater(RatioKernel kernel) implements LayerUpdater {

    @Override
    public LightLayer recompute(HitRows rows, WeightedLight light) {
        return kernel.recompute(rows, light);
    }

    @Override
    public LightLayer update(HitRows rows, LightLayer before, LayerPlan plan, MaterialSet speculars) {
        // Without gains in the scene, rows have no owners. A light that had gains is then recomputed below, whatever its rows had before.
        WeightedLight computed = requireNonNull(plan.computed());
        WeightedLight from = rows.owner == null ? computed.withoutGains() : computed;
        WeightedLight to = plan.target();
        RatioRows layer = kernel.updateSpeculars(rows, from, (RatioRows) before, speculars);
        layer = plan.shadows().isEmpty() ? layer : kernel.updateShadows(rows, from, layer, plan.shadows());
        return switch (plan.update()) {
            case LightUpdate.Keep _ -> layer;
            case LightUpdate.Refresh _ -> kernel.recomputeContributions(rows, to, layer);
            case LightUpdate.Reweight _ -> kernel.update(rows, from, to, layer, ConeChange.NONE, false);
            case LightUpdate.FullRecompute _ -> recompute(rows, to);
            case LightUpdate.Partial p -> kernel.update(rows, from, to, layer, p.cone(), p.falloff());
        };
    }

    @Override
    public LightLayer convert(HitRows rows, WeightedLight light, LightLayer before) {
        return before instanceof LightRows layer ? kernel.fromTerms(rows, light, layer) : before;
    }

    @Override
    public LightLayer reorder(RowSplice splice, LightLayer before) {
        return kernel.splice(splice, (RatioRows) before, null);
    }

    @Override
    public LightLayer join(RowSplice splice, LightLayer before, LightLayer added, WeightedLight light) {
        return kernel.splice(splice, (RatioRows) before, (RatioRows) added);
    }

    @Override
    public LightRows terms(HitRows rows, WeightedLight light, LightLayer layer) {
        return kernel.terms(rows, light, (RatioRows) layer);
    }

    @Override
    public long rowsTouched() {
        return kernel.rowsTouched();
    }

    @Override
    public double minFalloff() {
        return kernel.minFalloff();
    }
}
