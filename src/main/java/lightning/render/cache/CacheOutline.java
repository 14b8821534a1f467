package lightning.render.cache;

import java.util.List;
import lightning.render.shading.SeenScenes;
import lightning.render.trace.Geometry;

/** What is known of a picture without its rows and colours: enough to understand these where they lie elsewhere. */
public record CacheOutline(Geometry geometry, SeenScenes scenes, List<KnownLight> lights, List<KnownLight> mirroredLights) {
    public static CacheOutline of(PixelCache cache) {
        return new CacheOutline(cache.geometry(), cache.scenes(), cache.lights(), cache.mirroredLights());
    }
}
