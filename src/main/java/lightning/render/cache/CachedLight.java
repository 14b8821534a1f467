package lightning.render.cache;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.LightLayer;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;

/**
 * Light of a cached scene with the stamp of its layers. Updates find the layers of a light through it.
 *
 * @param index index of its layer in a level: the light's index in the scene
 * @param light light of the scene with its light group applied
 * @param stamp inputs of its layers, possibly outdated if the light is off; null if there are no layers
 */
public record CachedLight(int index, Light light, @Nullable LayerStamp stamp) {

    /** Returns all lights of a scene, in order, each with its stamp from {@code stamps}, or null. */
    public static List<CachedLight> ofScene(Scene scene, Function<Light, LayerStamp> stamps) {
        List<CachedLight> lights = new ArrayList<>();
        for (Light light : scene.rig().effectiveLights()) {
            lights.add(new CachedLight(lights.size(), light, stamps.apply(light)));
        }
        return lights;
    }

    /** Returns all lights of a scene, in order, each with the stamp of the layers that a first pass computes; null if it is off. */
    public static List<CachedLight> ofScene(Scene scene) {
        return ofScene(scene, light -> {
            WeightedLight weighted = WeightedLight.of(light, scene);
            return weighted.isDark() ? null : LayerStamp.ofComputed(weighted);
        });
    }

    /** Returns its layer over a level's rows; null if it was never on. */
    public @Nullable LightLayer layer(TileLevel level) {
        return level.layers()[index];
    }

    /** Returns the same light with the stamp of layers that were just computed; stays without a stamp if there are no layers. */
    public CachedLight withComputedStamp() {
        return new CachedLight(index, light, stamp == null ? null : new LayerStamp.ComputedStamp(stamp.light(), stamp.fog()));
    }
}
