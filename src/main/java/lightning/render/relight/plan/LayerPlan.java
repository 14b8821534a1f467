package lightning.render.relight.plan;

import lightning.render.cache.CachedLight;
import lightning.render.cache.LayerStamp;
import lightning.render.cache.TileLevel;
import lightning.render.shading.ConeChange;
import lightning.render.shading.LightLayer;
import lightning.render.shading.WeightedLight;
import lightning.render.trace.ShapeChange;
import lightning.scene.Light;
import lightning.scene.Scene;
import lightning.scene.ShapeLinks;

/**
 * The update of one light's layers over the rows of a level.
 *
 * @param target   the light as wanted
 * @param base     the light known before that it goes on from, null for none
 * @param update   what to do
 * @param shadows  what became of the shapes that throw shadows in its light
 * @param computed the light that its layers were computed for, shadowed by the shapes that shadow it afterwards; null where there are
 *                 none
 * @param previous    what the scene before has of it, its weight there included; null where it has no such light
 */
public record LayerPlan(WeightedLight target, CachedLight base, LightUpdate update, ShapeChange shadows, WeightedLight computed,
        WeightedLight previous) {

    /** @param known the scene before */
    public static LayerPlan of(WeightedLight target, CachedLight from, LightUpdate update, ShapeChange shadows, Scene known) {
        LayerStamp stamp = from == null ? null : from.stamp();
        return new LayerPlan(target, from, update, shadows, stamp == null ? null
                : WeightedLight.ofSwitchedOn(stamp.light().withShadowedBy(shadowedBy(target.light(), stamp, update)), known),
                from == null ? null : WeightedLight.of(from.light(), known));
    }

    /** The light as wanted. */
    public Light light() {
        return target.light();
    }

    /**
     * Which shapes throw shadows in the light as its layer shows it afterwards, where the update goes on from one.
     *
     * @param before what the layers there are were computed for
     */
    static ShapeLinks shadowedBy(Light light, LayerStamp before, LightUpdate update) {
        return update instanceof LightUpdate.Keep ? before.light().shadowedBy() : light.shadowedBy();
    }

    /**
     * What the layer shows afterwards, or null if there is none.
     *
     * @param minFalloff {@link LayerUpdater#minFalloff} of all threads
     */
    LayerStamp stamp(UpdateMethod method, double minFalloff) {
        LayerStamp before = base == null ? null : base.stamp();
        return switch (update) {
            case LightUpdate.Keep _ -> before;
            case LightUpdate.FullRecompute _,LightUpdate.Refresh _ -> LayerStamp.ofComputed(light());
            case LightUpdate.Reweight _ -> method.stamp(before, light(), true, false, minFalloff);
            case LightUpdate.Partial p -> method.stamp(before, light(), p.weight(), p.falloff(), minFalloff);
        };
    }

    /** The layer over one tile's rows before the update; null where there is none. */
    public LightLayer layerBefore(TileLevel old) {
        return base == null ? null : base.layer(old);
    }

    /** Whether the light's weight changes: color, intensity, on or solo. */
    private boolean changesWeight() {
        return previous == null || previous.red() != target.red() || previous.green() != target.green() || previous.blue() != target.blue();
    }

    /** Whether it changes anything in the picture, as far as one light's plan tells. */
    boolean changesImage() {
        return changesWeight() || !(update instanceof LightUpdate.Keep) || !shadows.isEmpty();
    }

    /** Whether anti-aliasing may see other edges of the light than before over a tile's rows: it sees neither weight nor falloff. */
    boolean canChangeEdges(TileLevel old, LightLayer after) {
        boolean wasDark = previous == null || previous.isDark();
        return wasDark != target.isDark() || layerBefore(old) != after && !(preservesStates() && shadows.isEmpty());
    }

    private boolean preservesStates() {
        return switch (update) {
            case LightUpdate.Keep _,LightUpdate.Reweight _,LightUpdate.Refresh _ -> true;
            case LightUpdate.Partial p -> p.cone() == ConeChange.NONE;
            case LightUpdate.FullRecompute _ -> false;
        };
    }

    /** Whether the color of any of a tile's rows may differ from before. */
    boolean canChangeColors(TileLevel old, LightLayer after) {
        LightLayer before = layerBefore(old);
        boolean lights = before != null && before.litCount() > 0 || after != null && after.litCount() > 0;
        return lights && (before != after || changesWeight());
    }
}
