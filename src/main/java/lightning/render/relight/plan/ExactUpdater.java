package lightning.render.relight.plan;

import static java.util.Objects.requireNonNull;

import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.ColumnAllocator;
import lightning.render.shading.layer.LightKernel;
import lightning.render.shading.layer.LightLayer;
import lightning.render.shading.layer.LightRows;
import lightning.render.shading.layer.ScratchColumns;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.RowSplice;
import org.jspecify.annotations.Nullable;

/** Updater that leaves a compact layer with the bits of a full trace in all its terms. Use one instance per thread. */
final class ExactUpdater implements LayerUpdater {
    private final LightKernel kernel;
    private final boolean premultiplies;
    private final ScratchColumns scratch = new ScratchColumns();

    /** @param premultiplies true if recomputed layers without highlights store cosine times falloff */
    ExactUpdater(LightKernel kernel, boolean premultiplies) {
        this.kernel = kernel;
        this.premultiplies = premultiplies;
    }

    /** Uses scratch columns, so that only stored columns need new memory. */
    @Override
    public LightLayer recompute(HitRows rows, WeightedLight light) {
        scratch.reset();
        LightRows layer = kernel.recompute(rows, light.source(), scratch);
        return premultiplies ? layer.copyPremultiplied(rows.count) : layer.copyCompact(rows.count);
    }

    @Override
    public LightLayer update(HitRows rows, LightLayer before, LayerPlan plan, MaterialSet speculars) {
        LightRows known = (LightRows) before;
        LightRows layer = compactIfChanged(known,
                kernel.updateSpeculars(rows, requireNonNull(plan.computed()).source(), known, speculars, ColumnAllocator.NEW_ARRAYS), rows);
        if (!plan.shadows().isEmpty()) {
            layer = compactIfChanged(layer,
                    kernel.updateShadows(rows, requireNonNull(plan.computed()).source(), layer, plan.shadows(), ColumnAllocator.NEW_ARRAYS),
                    rows);
        }
        return switch (plan.update()) {
            case LightUpdate.Keep _,LightUpdate.Reweight _,LightUpdate.Refresh _ -> layer;
            case LightUpdate.FullRecompute _ -> recompute(rows, plan.target());
            case LightUpdate.Partial p ->
                    compactIfChanged(layer,
                            kernel.update(rows, plan.target().source(), layer, p.cone(), p.falloff(), ColumnAllocator.NEW_ARRAYS), rows);
        };
    }

    @Override
    public LightLayer convert(HitRows rows, WeightedLight light, LightLayer before) {
        return before instanceof LightRows ? before
                : compactIfChanged(null, kernel.recomputeTerms(rows, light.source(), before, ColumnAllocator.NEW_ARRAYS), rows);
    }

    @Override
    public LightLayer reorder(RowSplice splice, LightLayer before) {
        return compactIfChanged(null, kernel.reorder(splice, (LightRows) before), splice.rows());
    }

    @Override
    public LightLayer join(RowSplice splice, LightLayer before, LightLayer added, WeightedLight light) {
        return compactIfChanged(null, kernel.join(splice, (LightRows) before, (LightRows) added, light.source()), splice.rows());
    }

    @Override
    public LightRows terms(HitRows rows, WeightedLight light, LightLayer layer) {
        return (LightRows) layer;
    }

    @Override
    public long rowsTouched() {
        return kernel.rowsTouched();
    }

    @Override
    public double minFalloff() {
        return 1;
    }

    /**
     * Returns a layer without redundant columns. A layer that an edit did not change is compact already, so its columns are not
     * scanned again.
     */
    private static LightRows compactIfChanged(@Nullable LightRows before, LightRows after, HitRows rows) {
        return after == before ? after : after.compact(rows.count);
    }
}
