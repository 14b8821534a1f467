package lightning.render.relight.plan;

import lightning.render.cache.LayerStamp;
import lightning.render.cache.PixelCache;
import lightning.render.image.DisplayCurve;
import lightning.render.shading.LightKernel;
import lightning.render.shading.Luminaire;
import lightning.scene.Light;
import lightning.scene.Scene;

/** How an accuracy carries out edits: what layers hold, which update leads to a light, and what the updates lose. */
public interface UpdateMethod {
    /**
     * The least update to a light.
     *
     * @param before what its layers were computed for
     * @param scene  the scene wanted
     */
    LightUpdate update(LayerStamp before, Luminaire wanted, Scene scene);

    /**
     * What a layer shows after an update that kept some of its terms.
     *
     * @param before       what it was computed for
     * @param weight       whether the light's weight changed
     * @param falloff      whether its falloff changed
     * @param leastFalloff {@link LayerUpdater#leastFalloff} of all threads
     */
    LayerStamp stamp(LayerStamp before, Light light, boolean weight, boolean falloff, double leastFalloff);

    /**
     * What updates layers in one thread.
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
     * What makes up for errors that may show.
     *
     * @param exposure how the film is displayed, in stops
     * @return {@link UpdatePlan.Nothing} where none may
     */
    UpdatePlan refresh(PixelCache cache, double exposure, DisplayCurve curve);
}
