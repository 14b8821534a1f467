package lightning.render.relight;

import java.util.function.Predicate;
import lightning.render.cache.PixelCache;
import lightning.render.relight.tile.RenderJob;
import lightning.render.shading.RequiredWork;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialTable;
import lightning.scene.Material;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;

/** What first passes take for the shapes of a scene: what is known of them already, as far as it serves. */
final class GeometrySource {
    /** What is known elsewhere; may be null. */
    private Geometry shared;

    /** Offers what is known elsewhere of some shapes; null is nothing. */
    void set(Geometry geometry) {
        shared = geometry;
    }

    /**
     * What rays of a scene can meet: of the cache, or offered, where one of them serves, else made.
     *
     * @param target as the view shows it
     * @param cache  what is kept of a picture; null for none
     */
    Geometry get(Scene target, PixelCache cache, ViewEffects view) {
        // Anti-aliasing looks into mirrors for edges, so what mirrors nothing must not be followed then.
        Predicate<Material> mirrors =
                RenderJob.needsEdges(target) ? MaterialTable.CASTS_REFLECTIONS : RequiredWork.of(view).mirrorMaterials();
        Geometry own = cache == null ? null : cache.geometry();
        Geometry best = shared != null && (own == null || !own.canServe(target)) ? shared : own;
        return best == null ? new Geometry(target, mirrors) : best.forScene(target, mirrors);
    }
}
