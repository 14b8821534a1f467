package lightning.render.relight.plan;

import lightning.render.cache.CachedLight;
import lightning.render.cache.LayerStamp;
import lightning.render.cache.TileLevel;
import lightning.render.shading.LightLayer;
import lightning.render.shading.WeightedLight;
import lightning.render.trace.ShapeChange;
import lightning.scene.Light;
import lightning.scene.Scene;
import lightning.scene.ShapeLinks;

/**
 * Update of one light's layers over the rows of a level.
 *
 * @param target   the target light
 * @param base     the cached light to start from, or null
 * @param update   the update to apply
 * @param shadows  change of the shapes that cast shadows from this light
 * @param computed the light that its layers were computed for, shadowed by the shapes that shadow it afterwards; null if there are
 *                 no layers
 * @param previous the light in the previous scene with its weight there; null if it did not exist
 */
public record LayerPlan(WeightedLight target, CachedLight base, LightUpdate update, ShapeChange shadows, WeightedLight computed,
        WeightedLight previous) {

    /** @param known the previous scene */
    public static LayerPlan of(WeightedLight target, CachedLight from, LightUpdate update, ShapeChange shadows, Scene known) {
        LayerStamp stamp = from == null ? null : from.stamp();
        return new LayerPlan(target, from, update, shadows, stamp == null ? null
                : WeightedLight.ofSwitchedOn(stamp.light().withShadowedBy(shadowedBy(target.light(), stamp, update)), known),
                from == null ? null : WeightedLight.of(from.light(), known));
    }

    /** Returns the target light. */
    public Light light() {
        return target.light();
    }

    /**
     * Returns the links of shapes that cast shadows from the light in its updated layer.
     *
     * @param before stamp of the current layers
     */
    static ShapeLinks shadowedBy(Light light, LayerStamp before, LightUpdate update) {
        return update instanceof LightUpdate.Keep ? before.light().shadowedBy() : light.shadowedBy();
    }

    /**
     * Returns the stamp of the updated layer, or null if there is none.
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

    /** Returns the layer over one tile's rows before the update; null if there is none. */
    public LightLayer layerBefore(TileLevel old) {
        return base == null ? null : base.layer(old);
    }

    /** Returns whether the light's weight changes: color, intensity, on or solo. */
    private boolean changesWeight() {
        return previous == null || isOtherWeight(previous, target);
    }

    private static boolean isOtherWeight(WeightedLight a, WeightedLight b) {
        return a.red() != b.red() || a.green() != b.green() || a.blue() != b.blue();
    }

    /** Returns whether this plan alone changes the picture. */
    boolean changesImage() {
        return changesWeight() || !(update instanceof LightUpdate.Keep) || !shadows.isEmpty();
    }

    /** Returns whether the light may change the colors by which anti-aliasing detects edges in a tile's rows. */
    boolean canChangeEdges(TileLevel old, LightLayer after) {
        return canChange(old, after, changesEdgeWeight());
    }

    private boolean changesEdgeWeight() {
        return previous == null || isOtherWeight(previous.forEdges(), target.forEdges());
    }

    /** Returns whether the color of any of a tile's rows may change. */
    boolean canChangeColors(TileLevel old, LightLayer after) {
        return canChange(old, after, changesWeight());
    }

    private boolean canChange(TileLevel old, LightLayer after, boolean weightChanged) {
        LightLayer before = layerBefore(old);
        boolean lights = before != null && before.litCount() > 0 || after != null && after.litCount() > 0;
        return lights && (before != after || weightChanged);
    }
}
