package lightning.render.cache;

import java.util.List;
import lightning.render.shading.RenderedScenes;
import lightning.render.trace.Geometry;

/**
 * Metadata of a cached image that has no indirect light, without its rows and colors: the data required to interpret these if they are
 * stored elsewhere.
 */
public record CacheMetadata(Geometry geometry, RenderedScenes scenes, List<CachedLight> lights, List<CachedLight> mirroredLights) {
    public static CacheMetadata of(PixelCache cache) {
        return new CacheMetadata(cache.geometry(), cache.scenes(), cache.lights(), cache.mirroredLights());
    }
}
