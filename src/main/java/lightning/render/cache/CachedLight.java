package lightning.render.cache;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import lightning.render.shading.LightLayer;
import lightning.scene.Light;
import lightning.scene.Scene;

/**
 * A light of the scene that levels show, and what its layers over their rows were computed for. Whoever updates a light finds its
 * layers through it.
 *
 * @param index where its layer stands among those of a level: the light's place in the scene
 * @param light as the scene has it and its bank makes it
 * @param stamp what its layers were computed for, which may be older where the light does not shine; null where there are none
 */
public record CachedLight(int index, Light light, LayerStamp stamp) {

    /** All lights of a scene, in its order, each with the stamp that {@code stamps} tells, or null. */
    public static List<CachedLight> ofScene(Scene scene, Function<Light, LayerStamp> stamps) {
        List<CachedLight> lights = new ArrayList<>();
        for (Light light : scene.rig().effectiveLights()) {
            lights.add(new CachedLight(lights.size(), light, stamps.apply(light)));
        }
        return lights;
    }

    /** Its layer over a level's rows; null where it never shone. */
    public LightLayer layer(TileLevel level) {
        return level.layers()[index];
    }

    /** The same light where its layers were just computed for what they show; no layer comes where there is none. */
    public CachedLight withComputedStamp() {
        return new CachedLight(index, light, stamp == null ? null : LayerStamp.ofComputed(stamp.light()));
    }
}
