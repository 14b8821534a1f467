package lightning.render.cache;

import java.util.List;
import lightning.render.gather.GatherStructure;
import lightning.render.shading.RenderedScenes;
import lightning.render.trace.Geometry;
import lightning.scene.GatherSettings;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * Metadata of a cached image, without its rows and colors: the data required to interpret these if they are stored elsewhere.
 *
 * @param indirect         indirect light of the scene
 * @param mirroredIndirect indirect light in mirrors
 */
public record CacheMetadata(Geometry geometry, RenderedScenes scenes, List<CachedLight> lights, List<CachedLight> mirroredLights,
        @Nullable Paths indirect, @Nullable Paths mirroredIndirect) {
    /**
     * Metadata of indirect light.
     *
     * @param settings it was computed with
     * @param metadata what its paths refer to
     */
    record Paths(GatherSettings settings, GatherStructure.Metadata metadata) {
        static @Nullable Paths of(@Nullable IndirectCache cache) {
            return cache == null ? null : new Paths(cache.settings(), cache.structure().metadata());
        }

        static @Nullable Paths ofScene(Geometry geometry, Scene scene) {
            return GatherSettings.of(scene)
                    .map(settings -> new Paths(settings, GatherStructure.Metadata.of(geometry, scene, settings))).orElse(null);
        }

        static boolean areSame(@Nullable Paths a, @Nullable Paths b) {
            return a == null || b == null ? a == b : a.settings.equals(b.settings) && a.metadata.isSame(b.metadata);
        }
    }

    /**
     * Returns what follows from a scene alone: the metadata of its first pass. Lights that are off have no layers.
     *
     * @param geometry its geometry
     */
    static CacheMetadata ofScene(Geometry geometry, Scene scene) {
        List<CachedLight> lights = CachedLight.ofScene(scene);
        Paths paths = Paths.ofScene(geometry, scene);
        return new CacheMetadata(geometry, new RenderedScenes(scene, scene), lights, lights, paths, paths);
    }

    public static CacheMetadata of(PixelCache cache) {
        return new CacheMetadata(cache.geometry(), cache.scenes(), cache.shown().lights(), cache.mirrored().lights(),
                Paths.of(cache.indirect()),
                Paths.of(cache.mirrored().indirect()));
    }
}
