package lightning.render.cache;

import lightning.scene.Light;

/** What a layer shows. */
public interface LayerStamp {
    /** The light that it was computed for. */
    Light light();

    /** A layer that was computed and not scaled. */
    record ComputedStamp(Light light) implements LayerStamp {}

    /** A layer that was just computed. */
    static LayerStamp ofComputed(Light light) {
        return new ComputedStamp(light);
    }
}
