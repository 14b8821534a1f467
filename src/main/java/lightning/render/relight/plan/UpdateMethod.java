package lightning.render.relight.plan;

import lightning.render.cache.LayerStamp;
import lightning.render.cache.PixelCache;
import lightning.render.image.DisplayCurve;
import lightning.render.shading.LightKernel;
import lightning.render.shading.WeightedLight;
import lightning.scene.Light;
import lightning.scene.Scene;

/** How an accuracy carries out edits: the contents of layers, the update for an edited light, and the error of updates. */
public interface UpdateMethod {
    /**
     * The least update to a light.
     *
     * @param before what its layers were computed for
     * @param scene  the scene wanted
     */
    LightUpdate update(LayerStamp before, WeightedLight target, Scene scene);

    /**
     * The stamp of a layer after an update that kept some of its terms.
     *
     * @param before       what it was computed for
     * @param weight       whether the light's weight changed
     * @param falloff      whether its falloff changed
     * @param minFalloff {@link LayerUpdater#minFalloff} of all threads
     */
    LayerStamp stamp(LayerStamp before, Light light, boolean weight, boolean falloff, double minFalloff);

    /**
     * Creates the updater of one thread.
     *
     * @param lights how many the scene has
     */
    LayerUpdater updater(LightKernel kernel, int lights);

    /**
     * The most bytes that a light's layers take for each row.
     *
     * @param metallic whether any material is metallic
     * @param tinted   whether light passes any
     */
    long bytesPerRow(Light light, boolean metallic, boolean tinted);

    /** How far any value of the film may be from the exact one, linear. */
    double errorBound(PixelCache cache);

    /**
     * The update that removes errors large enough to show.
     *
     * @param exposure how the film is displayed, in stops
     * @return {@link UpdatePlan.Nothing} if no error can show
     */
    UpdatePlan refresh(PixelCache cache, double exposure, DisplayCurve curve);
}
