package lightning.render.cache;

import lightning.scene.light.Light;

/** Identity of the inputs that a layer was computed from. */
public interface LayerStamp {
    /** Returns the light that the layer was computed for. */
    Light light();

    /** Stamp of a layer that was computed and not scaled. */
    record ComputedStamp(Light light) implements LayerStamp {}

    /** Returns the stamp of a layer that was just computed. */
    static LayerStamp ofComputed(Light light) {
        return new ComputedStamp(light);
    }
}
