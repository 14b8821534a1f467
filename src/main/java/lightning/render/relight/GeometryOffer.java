package lightning.render.relight;

import java.util.function.Predicate;
import lightning.render.cache.PixelCache;
import lightning.render.relight.tile.Job;
import lightning.render.shading.Demands;
import lightning.render.trace.Geometry;
import lightning.render.trace.MaterialTable;
import lightning.scene.Material;
import lightning.scene.Scene;
import lightning.scene.effects.ViewEffects;

/** What first passes take for the shapes of a scene: what is known of them already, as far as it serves. */
final class GeometryOffer {
    /** What is known elsewhere; may be null. */
    private Geometry shared;

    /** Offers what is known elsewhere of some shapes; null is nothing. */
    void set(Geometry geometry) {
        shared = geometry;
    }

    /**
     * What rays of a scene can meet: of the cache, or offered, where one of them serves, else made.
     *
     * @param wanted as the view shows it
     * @param cache  what is kept of a picture; null for none
     */
    Geometry take(Scene wanted, PixelCache cache, ViewEffects view) {
        // Anti-aliasing looks into mirrors for edges, so what mirrors nothing must not be followed then.
        Predicate<Material> mirrors = Job.seeksEdges(wanted) ? MaterialTable.MIRRORS : Demands.of(view).mirrors();
        Geometry own = cache == null ? null : cache.geometry();
        Geometry best = shared != null && (own == null || !own.serves(wanted)) ? shared : own;
        return best == null ? new Geometry(wanted, mirrors) : best.forScene(wanted, mirrors);
    }
}
