package lightning.render.relight;

import java.util.function.Predicate;
import lightning.render.cache.PixelCache;
import lightning.render.relight.tile.RenderJob;
import lightning.render.shading.layer.RequiredWork;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialTable;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/** Supplies first passes with geometry; reuses cached or shared geometry that serves the scene. */
final class GeometrySource {
    /** Geometry shared by another renderer. */
    private @Nullable Geometry shared;

    /** Sets shared geometry; null removes it. */
    void set(@Nullable Geometry geometry) {
        shared = geometry;
    }

    /** Returns the shared geometry; null if there is none. */
    @Nullable
    Geometry shared() {
        return shared;
    }

    /**
     * Returns the geometry of a scene: the cached or shared geometry if it serves the scene, otherwise a new one.
     *
     * @param target scene as the view shows it
     * @param cache  cache of a picture
     */
    Geometry get(Scene target, @Nullable PixelCache cache, ViewEffects view) {
        // Anti-aliasing finds edges in mirrors, so rays must then not be followed from materials that do not mirror.
        Predicate<Material> mirrors =
                RenderJob.needsEdges(target) ? MaterialTable.CASTS_REFLECTIONS : RequiredWork.of(view).mirrorMaterials();
        Geometry own = cache == null ? null : cache.geometry();
        Geometry best = shared != null && (own == null || !own.canServe(target)) ? shared : own;
        return best == null ? Geometry.of(target, mirrors) : best.forScene(target, mirrors);
    }
}
