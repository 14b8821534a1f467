package lightning.render.shading;

import java.util.HashMap;
import java.util.Map;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.Tracer;
import lightning.scene.ShapeLinks;
import lightning.scene.effects.ViewEffects;

/**
 * Which rows of a tile a light shines on at all, and who asks for ways to it: by the shapes that it is linked to. A row that it does not
 * shine on counts as outside its cone. Lights without links share one caster, and no row of theirs is looked at. One for each thread.
 */
final class LightLinks {
    private final Geometry geometry;
    private final Tracer tracer;
    private final ViewEffects view;
    private final ShadowCaster unrestrictedCaster;
    private final Map<ShapeLinks, ShadowCaster> restrictedCasters = new HashMap<>();

    LightLinks(Geometry geometry, Tracer tracer, ViewEffects view) {
        this.geometry = geometry;
        this.tracer = tracer;
        this.view = view;
        Geometry casting = geometry.shadowGeometry(ShapeLinks.ALL);
        unrestrictedCaster = new ShadowCaster(casting, casting == geometry ? tracer : tracer.withGeometry(casting), view);
    }

    /** Who asks whether ways to a light are free. */
    ShadowCaster shadowCaster(LightSource source) {
        ShapeLinks shadowedBy = source.light().shadowedBy();
        return shadowedBy.isAll() ? unrestrictedCaster : restrictedCasters.computeIfAbsent(shadowedBy, this::createCaster);
    }

    private ShadowCaster createCaster(ShapeLinks shadowedBy) {
        Geometry casting = geometry.shadowGeometry(shadowedBy);
        return new ShadowCaster(casting, tracer.withGeometry(casting), view);
    }

    /** Shadow rays cast since the start. */
    long shadowRays() {
        return unrestrictedCaster.rayCount() + restrictedCasters.values().stream().mapToLong(ShadowCaster::rayCount).sum();
    }

    /** Of each primitive whether a light shines on it; null where it does on all. */
    boolean[] litPrimitives(LightSource source) {
        ShapeLinks illuminated = source.light().illuminates();
        return illuminated.isAll() ? null : geometry.linkedPrimitives(illuminated);
    }

    /** Whether it shines on any of the rows, as far as links tell. */
    boolean canReach(LightSource source, HitRows rows) {
        boolean[] lit = litPrimitives(source);
        boolean any = lit == null || rows.count == 0;
        for (int i = 0; i < rows.count && !any; i++) {
            any = lit[rows.owner[i]];
        }
        return any;
    }

    /** Leaves out rows of a set that it does not shine on. */
    void retainLit(LightSource source, HitRows rows, int[] set) {
        boolean[] lit = litPrimitives(source);
        for (int i = 0; lit != null && i < rows.count; i++) {
            if (!lit[rows.owner[i]]) {
                RowBits.remove(set, i, i + 1);
            }
        }
    }
}
