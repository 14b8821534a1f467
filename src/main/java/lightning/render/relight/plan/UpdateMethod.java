package lightning.render.relight.plan;

import lightning.render.cache.LayerStamp;
import lightning.render.cache.PixelCache;
import lightning.render.image.DisplayCurve;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.LightKernel;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;

/** Update method of an accuracy: the contents of layers, the update for an edited light, and the error of updates. */
public interface UpdateMethod {
    /**
     * Returns the least update to a light.
     *
     * @param before stamp of its current layers
     * @param scene  the target scene
     */
    LightUpdate update(LayerStamp before, WeightedLight target, Scene scene);

    /**
     * Returns the stamp of a layer after an update that kept some of its terms.
     *
     * @param before     stamp of the current layer
     * @param weight     true if the light's weight changed
     * @param falloff    true if its falloff changed
     * @param minFalloff {@link LayerUpdater#minFalloff} of all threads
     */
    LayerStamp stamp(@Nullable LayerStamp before, WeightedLight light, boolean weight, boolean falloff, double minFalloff);

    /**
     * Creates the updater of one thread.
     *
     * @param lights number of the scene's lights
     */
    LayerUpdater updater(LightKernel kernel, int lights);

    /**
     * Returns the maximum bytes per row of a light's layers.
     *
     * @param metallic true if any material is metallic
     * @param tinted   true if light passes through any material
     */
    long bytesPerRow(Light light, boolean metallic, boolean tinted);

    /** Returns whether films have the bits of a full trace; otherwise all samples keep their colors, which bound the error. */
    boolean isExact();

    /** Returns whether layers contain the lights' gains on shapes, so that they become invalid if groups of shapes change. */
    boolean storesGains();

    /** Returns the largest difference of any film value from the exact one, linear. */
    double errorBound(PixelCache cache);

    /**
     * Returns the update that removes visible errors.
     *
     * @param exposure exposure of the display in stops
     * @return {@link UpdatePlan.Nothing} if no error can be visible
     */
    UpdatePlan refresh(PixelCache cache, double exposure, DisplayCurve curve);
}
