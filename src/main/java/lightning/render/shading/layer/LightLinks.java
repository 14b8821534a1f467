package lightning.render.shading.layer;

import java.util.HashMap;
import java.util.Map;
import lightning.render.shading.LightSource;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.Tracer;
import lightning.scene.effects.ViewEffects;
import lightning.scene.value.ShapeLinks;
import org.jspecify.annotations.Nullable;

/**
 * Light linking for the rows of a tile: selects the rows that a light illuminates and the caster of its shadow rays. A row that is
 * not linked counts as outside the cone. Lights without links share one caster and skip the row test. Use one instance per thread.
 */
final class LightLinks {
    private final Geometry geometry;
    private final Tracer tracer;
    private final ViewEffects view;
    private final ShadowCaster unrestrictedCaster;
    private final Map<ShapeLinks, ShadowCaster> restrictedCasters = new HashMap<>();
    private final Map<String, long[]> rayCounts = new HashMap<>();

    LightLinks(Geometry geometry, Tracer tracer, ViewEffects view) {
        this.geometry = geometry;
        this.tracer = tracer;
        this.view = view;
        Geometry casting = geometry.shadowGeometry(ShapeLinks.ALL);
        unrestrictedCaster = new ShadowCaster(casting, casting == geometry ? tracer : tracer.withGeometry(casting), view, rayCounts);
    }

    /** Returns the shadow caster of a light. */
    ShadowCaster shadowCaster(LightSource source) {
        ShapeLinks shadowedBy = source.light().shadowCasters();
        return shadowedBy.isAll() ? unrestrictedCaster : restrictedCasters.computeIfAbsent(shadowedBy, this::createCaster);
    }

    /** Returns the shadow caster of lights that all shapes shadow. */
    ShadowCaster unrestrictedCaster() {
        return unrestrictedCaster;
    }

    private ShadowCaster createCaster(ShapeLinks shadowedBy) {
        Geometry casting = geometry.shadowGeometry(shadowedBy);
        return new ShadowCaster(casting, tracer.withGeometry(casting), view, rayCounts);
    }

    /** Returns the number of all shadow rays since the start. */
    long shadowRayCount() {
        return rayCounts.values().stream().mapToLong(count -> count[0]).sum();
    }

    /** Returns the number of shadow rays of each light since the start, by its name. */
    Map<String, Long> shadowRays() {
        Map<String, Long> counts = new HashMap<>();
        rayCounts.forEach((light, count) -> counts.put(light, count[0]));
        return counts;
    }

    /** Returns for each primitive whether the light illuminates it; null if it illuminates all. */
    boolean @Nullable [] litPrimitives(LightSource source) {
        ShapeLinks illuminated = source.light().illuminates();
        return illuminated.isAll() ? null : geometry.linkedPrimitives(illuminated);
    }

    /** Returns whether the light's links include any of the rows. */
    boolean canReach(LightSource source, HitRows rows) {
        boolean[] lit = litPrimitives(source);
        boolean any = lit == null || rows.count == 0;
        for (int i = 0; i < rows.count && !any; i++) {
            assert lit != null && rows.owner != null;
            any = lit[rows.owner[i]];
        }
        return any;
    }

    /**
     * Removes from a set the rows that the light does not illuminate. Rows without owners all stay: an edit removes the last links of
     * the scene, and will update the layers that had some.
     */
    void retainLit(LightSource source, HitRows rows, int[] set) {
        boolean[] lit = rows.owner == null ? null : litPrimitives(source);
        for (int i = 0; lit != null && i < rows.count; i++) {
            assert rows.owner != null;
            if (!lit[rows.owner[i]]) {
                RowBits.remove(set, i, i + 1);
            }
        }
    }
}
