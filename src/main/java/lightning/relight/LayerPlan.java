package lightning.relight;

import lightning.scene.Light;

/**
 * The update of one light's layer.
 *
 * @param light  the light as wanted
 * @param from   which layer of the old cache it goes on from, −1 for none
 * @param before the light that the old layer was computed for, null for none
 * @param update what to do
 */
public record LayerPlan(Light light, int from, Light before, LightUpdate update) {
    /** The light that the layer shows afterwards, or null if there is none. */
    Light stamp() {
        return update instanceof LightUpdate.Keep ? before : light;
    }
}
