package lightning.render.cache;

import lightning.render.fog.FogMedium;
import lightning.render.shading.WeightedLight;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;

/** Identity of the inputs that a layer was computed from. */
public interface LayerStamp {
    /** Returns the light that the layer was computed for. */
    Light light();

    /** Returns the fog that dims the light on its way to surfaces; null if there is none. */
    @Nullable
    FogMedium fog();

    /** Stamp of a layer that was computed and not scaled. */
    record ComputedStamp(Light light, @Nullable FogMedium fog) implements LayerStamp {}

    /** Returns the stamp of a layer in clear air that was just computed. */
    static LayerStamp ofComputed(Light light) {
        return new ComputedStamp(light, null);
    }

    /** Returns the stamp of a layer that was just computed. */
    static LayerStamp ofComputed(WeightedLight light) {
        return new ComputedStamp(light.light(), light.source().fog());
    }
}
