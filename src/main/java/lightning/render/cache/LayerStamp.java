package lightning.render.cache;

import lightning.scene.Light;

/** What a layer shows. */
public interface LayerStamp {
    /** The light that it was computed for. */
    Light light();

    /** A layer that was computed and not scaled. */
    record Fresh(Light light) implements LayerStamp {}

    /** A layer that was just computed. */
    static LayerStamp fresh(Light light) {
        return new Fresh(light);
    }
}
