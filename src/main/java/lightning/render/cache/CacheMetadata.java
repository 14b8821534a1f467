package lightning.render.cache;

import java.util.List;
import lightning.render.shading.RenderedScenes;
import lightning.render.trace.Geometry;

/** What is known of a picture without its rows and colors: enough to understand these where they lie elsewhere. */
public record CacheMetadata(Geometry geometry, RenderedScenes scenes, List<CachedLight> lights, List<CachedLight> mirroredLights) {
    public static CacheMetadata of(PixelCache cache) {
        return new CacheMetadata(cache.geometry(), cache.scenes(), cache.lights(), cache.mirroredLights());
    }
}
