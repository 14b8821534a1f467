package lightning.render.relight.plan;

import lightning.render.cache.KnownLight;
import lightning.render.cache.LayerStamp;
import lightning.render.cache.TileLevel;
import lightning.render.shading.ConeChange;
import lightning.render.shading.LightLayer;
import lightning.render.shading.Luminaire;
import lightning.render.trace.ShapeChange;
import lightning.scene.Light;
import lightning.scene.Links;
import lightning.scene.Scene;

/**
 * The update of one light's layers over the rows of a level.
 *
 * @param wanted   the light as wanted
 * @param from     the light known before that it goes on from, null for none
 * @param update   what to do
 * @param shadows  what became of the shapes that throw shadows in its light
 * @param computed the light that its layers were computed for, shadowed by the shapes that shadow it afterwards; null where there are
 *                 none
 * @param shone    what the scene before has of it, its weight there included; null where it has no such light
 */
public record LayerPlan(Luminaire wanted, KnownLight from, LightUpdate update, ShapeChange shadows, Luminaire computed, Luminaire shone) {

    /** @param known the scene before */
    public static LayerPlan of(Luminaire wanted, KnownLight from, LightUpdate update, ShapeChange shadows, Scene known) {
        LayerStamp stamp = from == null ? null : from.stamp();
        return new LayerPlan(wanted, from, update, shadows, stamp == null ? null
                : Luminaire.shining(stamp.light().withShadowedBy(shadowedBy(wanted.light(), stamp, update)), known),
                from == null ? null : Luminaire.of(from.light(), known));
    }

    /** The light as wanted. */
    public Light light() {
        return wanted.light();
    }

    /**
     * Which shapes throw shadows in the light as its layer shows it afterwards, where the update goes on from one.
     *
     * @param before what the layers there are were computed for
     */
    static Links shadowedBy(Light light, LayerStamp before, LightUpdate update) {
        return update instanceof LightUpdate.Keep ? before.light().shadowedBy() : light.shadowedBy();
    }

    /**
     * What the layer shows afterwards, or null if there is none.
     *
     * @param leastFalloff {@link LayerUpdater#leastFalloff} of all threads
     */
    LayerStamp stamp(UpdateMethod method, double leastFalloff) {
        LayerStamp before = from == null ? null : from.stamp();
        return switch (update) {
            case LightUpdate.Keep _ -> before;
            case LightUpdate.FullRecompute _,LightUpdate.Refresh _ -> LayerStamp.fresh(light());
            case LightUpdate.Reweight _ -> method.stamp(before, light(), true, false, leastFalloff);
            case LightUpdate.Partial p -> method.stamp(before, light(), p.weight(), p.falloff(), leastFalloff);
        };
    }

    /** The layer over one tile's rows before the update; null where there is none. */
    public LightLayer before(TileLevel old) {
        return from == null ? null : from.layer(old);
    }

    /** Whether the light's weight changes: colour, intensity, on or solo. */
    private boolean reweights() {
        return shone == null || shone.red() != wanted.red() || shone.green() != wanted.green() || shone.blue() != wanted.blue();
    }

    /** Whether it changes anything in the picture, as far as one light's plan tells. */
    boolean changes() {
        return reweights() || !(update instanceof LightUpdate.Keep) || !shadows.isEmpty();
    }

    /** Whether anti-aliasing may see other edges of the light than before over a tile's rows: it sees neither weight nor falloff. */
    boolean recodes(TileLevel old, LightLayer after) {
        boolean wasDark = shone == null || shone.isDark();
        return wasDark != wanted.isDark() || before(old) != after && !(keepsStates() && shadows.isEmpty());
    }

    private boolean keepsStates() {
        return switch (update) {
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
