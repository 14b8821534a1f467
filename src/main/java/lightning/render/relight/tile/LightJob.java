package lightning.render.relight.tile;

import lightning.render.cache.LayerStamp;
import lightning.render.cache.TileLevel;
import lightning.render.relight.plan.LayerPlan;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.shading.ConeChange;
import lightning.render.shading.LightLayer;
import lightning.render.shading.Luminaire;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.ShapeChange;
import lightning.scene.Scene;

/**
 * What an update does to the layers of one light over the rows of a level.
 *
 * @param plan     how its layers follow from those before
 * @param light    the light as wanted
 * @param computed the light that its layers were computed for, shadowed by the shapes that shadow it afterwards; null where there are
 *                 none
 * @param shone    what the scene before has of it, its weight there included; null where it has no such light
 */
public record LightJob(LayerPlan plan, Luminaire light, Luminaire computed, Luminaire shone) {

    /** @param known the scene before */
    static LightJob of(LayerPlan plan, Luminaire light, Scene known) {
        LayerStamp stamp = plan.before();
        return new LightJob(plan, light, stamp == null ? null : Luminaire.shining(stamp.light()
                .withShadowedBy(LayerPlan.shadowedBy(plan.light(), stamp, plan.update())), known),
                plan.from() == null ? null : Luminaire.of(plan.from().light(), known));
    }

    /** Its layer over one tile's rows before the update; null where there is none. */
    LightLayer before(TileLevel old) {
        return plan.from() == null ? null : plan.from().layer(old);
    }

    /**
     * Its layer over one tile's rows after the update: that before where nothing of it changes; null where it never shone.
     *
     * @param speculars materials whose specular term changed
     */
    LightLayer after(TileLevel old, LayerUpdater updater, MaterialSet speculars) {
        LightLayer before = before(old);
        if (before == null) {
            // Never lit, or a mirror level that a deeper recursion added while the light was dark.
            return light.isDark() ? null : updater.full(old.rows(), light);
        }
        if (plan.update() instanceof LightUpdate.FullRecompute) {
            return updater.full(old.rows(), light);
        }
        ShapeChange shadows = plan.shadows();
        if (light.isDark() && !shadows.isEmpty() && updater.mayChange(old.rows(), computed, before, shadows)) {
            // Made anew once it shines.
            return null;
        }
        LightLayer ready = updater.speculars(old.rows(), computed, before, speculars);
        ready = shadows.isEmpty() ? ready : updater.shadowed(old.rows(), computed, ready, shadows);
        return updater.update(old.rows(), computed, light, ready, plan.update());
    }

    /** Whether its weight changes: colour, intensity, on or solo. */
    boolean reweights() {
        return shone == null || shone.red() != light.red() || shone.green() != light.green() || shone.blue() != light.blue();
    }

    /** Whether it changes anything in the picture, as far as one light's plan tells. */
    boolean changes() {
        return reweights() || !(plan.update() instanceof LightUpdate.Keep) || !plan.shadows().isEmpty();
    }

    /** Whether anti-aliasing may see other edges of it than before over a tile's rows: it sees neither weight nor falloff. */
    boolean recodes(TileLevel old, LightLayer after) {
        boolean wasDark = shone == null || shone.isDark();
        return wasDark != light.isDark() || before(old) != after && !(keepsStates() && plan.shadows().isEmpty());
    }

    private boolean keepsStates() {
        return switch (plan.update()) {
            case LightUpdate.Keep _,LightUpdate.Reweight _,LightUpdate.Refresh _ -> true;
            case LightUpdate.Partial p -> p.cone() == ConeChange.NONE;
            case LightUpdate.FullRecompute _ -> false;
        };
    }

    /** Whether the colour of any of a tile's rows may differ from before. */
    boolean recolors(TileLevel old, LightLayer after) {
        LightLayer before = before(old);
        boolean lights = before != null && before.lit() > 0 || after != null && after.lit() > 0;
        return lights && (before != after || reweights());
    }
}
