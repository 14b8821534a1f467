package lightning.render.relight.plan;

import lightning.render.cache.LayerStamp;
import lightning.render.cache.PixelCache;
import lightning.render.column.ColumnKind;
import lightning.render.image.DisplayCurve;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.LightKernel;
import lightning.render.shading.layer.LightRows;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;

/** Update method with the bits of a full trace: layers hold terms, which are never scaled. */
public record ExactMethod() implements UpdateMethod {
    /** With so many lights, layers without highlights store one column instead of two. */
    static final int MIN_PREMULTIPLIED_LIGHTS = 8;

    /** Layers of a dark light are updated once it shines. */
    @Override
    public LightUpdate update(LayerStamp before, WeightedLight target, Scene scene) {
        return target.isDark() ? new LightUpdate.Keep() : LightDifference.between(before, target).update();
    }

    @Override
    public LayerStamp stamp(@Nullable LayerStamp before, WeightedLight light, boolean weight, boolean falloff, double minFalloff) {
        return LayerStamp.ofComputed(light);
    }

    @Override
    public LayerUpdater updater(LightKernel kernel, int lights) {
        return new ExactUpdater(kernel, lights >= MIN_PREMULTIPLIED_LIGHTS);
    }

    @Override
    public long bytesPerRow(Light light, boolean metallic, boolean tinted) {
        return ColumnKind.bytesPerRow(LightRows.columns(light, metallic, tinted));
    }

    @Override
    public boolean isExact() {
        return true;
    }

    @Override
    public boolean storesGains() {
        return false;
    }

    @Override
    public double errorBound(PixelCache cache) {
        return 0;
    }

    @Override
    public UpdatePlan refresh(PixelCache cache, double exposure, DisplayCurve curve) {
        return new UpdatePlan.Nothing();
    }
}
