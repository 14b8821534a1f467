package lightning.render.shading;

import java.util.HashMap;
import java.util.Map;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.Tracer;
import lightning.scene.Links;
import lightning.scene.effects.ViewEffects;

/**
 * Which rows of a tile a light shines on at all, and who asks for ways to it: by the shapes that it is linked to. A row that it does not
 * shine on counts as outside its cone. Lights without links share one caster, and no row of theirs is looked at. One for each thread.
 */
final class LightLinks {
    private final Geometry geometry;
    private final Tracer tracer;
    private final ViewEffects view;
    private final ShadowCaster all;
    private final Map<Links, ShadowCaster> some = new HashMap<>();

    LightLinks(Geometry geometry, Tracer tracer, ViewEffects view) {
        this.geometry = geometry;
        this.tracer = tracer;
        this.view = view;
        Geometry casting = geometry.casting(Links.ALL);
        all = new ShadowCaster(casting, casting == geometry ? tracer : tracer.among(casting), view);
    }

    /** Who asks whether ways to a light are free. */
    ShadowCaster shadows(Lamp lamp) {
        Links by = lamp.light().shadowedBy();
        return by.isAll() ? all : some.computeIfAbsent(by, this::caster);
    }

    private ShadowCaster caster(Links by) {
        Geometry casting = geometry.casting(by);
        return new ShadowCaster(casting, tracer.among(casting), view);
    }

    /** Shadow rays cast since the start. */
    long shadowRays() {
        return all.rays() + some.values().stream().mapToLong(ShadowCaster::rays).sum();
    }

    /** Of each primitive whether a light shines on it; null where it does on all. */
    boolean[] lit(Lamp lamp) {
        Links on = lamp.light().illuminates();
        return on.isAll() ? null : geometry.linked(on);
    }

    /** Whether it shines on any of the rows, as far as links tell. */
    boolean reaches(Lamp lamp, HitRows rows) {
        boolean[] lit = lit(lamp);
        boolean any = lit == null || rows.count == 0;
        for (int i = 0; i < rows.count && !any; i++) {
            any = lit[rows.owner[i]];
        }
        return any;
    }

    /** Leaves out rows of a set that it does not shine on. */
    void keep(Lamp lamp, HitRows rows, int[] set) {
        boolean[] lit = lit(lamp);
        for (int i = 0; lit != null && i < rows.count; i++) {
            if (!lit[rows.owner[i]]) {
                RowBits.remove(set, i, i + 1);
            }
        }
    }
}
