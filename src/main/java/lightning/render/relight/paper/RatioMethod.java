package lightning.render.relight.paper;

import static java.util.Objects.requireNonNull;

import lightning.render.cache.CachedScene;
import lightning.render.cache.LayerStamp;
import lightning.render.cache.PixelCache;
import lightning.render.column.ColumnKind;
import lightning.render.image.DisplayCurve;
import lightning.render.relight.plan.LayerUpdater;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.LightDifference;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.relight.plan.PathUpdate;
import lightning.render.relight.plan.UpdateMethod;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.ConeChange;
import lightning.render.shading.layer.LightKernel;
import lightning.render.trace.MaterialTable;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;

/** The paper's method: layers hold finished contributions, which edits scale by ratios, with a running error bound. */
public record RatioMethod() implements UpdateMethod {

    /**
     * Follows the paper: a turned light (§4.5) and a light whose old weight is 0 (§4.1) are recomputed in full, shadow rays
     * included. Layers of a light that is off are updated once it shines.
     */
    @Override
    public LightUpdate update(LayerStamp before, WeightedLight target, Scene scene) {
        if (!scene.isActive(target.light())) {
            return new LightUpdate.Keep();
        }
        LightDifference difference = LightDifference.between(before, target);
        LightUpdate min = difference.update();
        if (min instanceof LightUpdate.Keep) {
            return min;
        }
        boolean usable = before.light().influence().isGained() || target.light().influence().isGained()
                || IntensityRatio
                        .between(WeightedLight.ofSwitchedOn(before.light(), scene), WeightedLight.ofSwitchedOn(target.light(), scene))
                        .isUsable();
        return difference.coneChange() == ConeChange.TURN || !usable ? new LightUpdate.FullRecompute(false) : min;
    }

    @Override
    public LayerStamp stamp(@Nullable LayerStamp before, WeightedLight light, boolean weight, boolean falloff, double minFalloff) {
        return RatioBound.stampAfterScaling(requireNonNull(before), light.light(), weight, falloff, minFalloff)
                .withFog(light.source().fog());
    }

    @Override
    public LayerUpdater updater(LightKernel kernel, int lights) {
        return new RatioUpdater(new RatioKernel(kernel));
    }

    @Override
    public long bytesPerRow(Light light, boolean metallic, boolean tinted) {
        return ColumnKind.bytesPerRow(RatioRows.columns(light, metallic, tinted));
    }

    @Override
    public boolean isExact() {
        return false;
    }

    @Override
    public boolean storesGains() {
        return true;
    }

    @Override
    public double errorBound(PixelCache cache) {
        return ErrorBound.of(cache).maxError(cache);
    }

    @Override
    public UpdatePlan refresh(PixelCache cache, double exposure, DisplayCurve curve) {
        boolean isScaled = isScaled(cache.shown()) || isScaled(cache.mirrored());
        return isScaled && ErrorBound.of(cache).isVisible(exposure, curve) ? refresh(cache) : new UpdatePlan.Nothing();
    }

    private static boolean isScaled(CachedScene known) {
        return known.lights().stream().anyMatch(light -> light.stamp() instanceof ScaledStamp stamp && stamp.roundings() > 0);
    }

    /** Plans the recomputation of all scaled contributions for the shown scene. */
    public static UpdatePlan.Relight refresh(PixelCache cache) {
        int depth = cache.scene().picture().depth();
        MaterialTable materials = cache.geometry().materials();
        return new UpdatePlan.Relight(refresh(cache.shown(), materials),
                cache.hasCurrentReflections() ? refresh(cache.mirrored(), materials) : null,
                depth, depth, PathUpdate.unchanged(cache));
    }

    private static LevelPlan refresh(CachedScene known, MaterialTable materials) {
        return LevelPlan.refresh(known, materials, light -> light.stamp() instanceof ScaledStamp stamp && stamp.roundings() > 0
                && known.scene().isActive(light.light()));
    }
}
