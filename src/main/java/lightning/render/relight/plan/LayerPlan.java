package lightning.render.relight.plan;

import lightning.render.cache.CachedLight;
import lightning.render.cache.LayerStamp;
import lightning.render.cache.TileLevel;
import lightning.render.shading.ObjectGains;
import lightning.render.shading.WeightedLight;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.ShapeChange;
import lightning.scene.Scene;
import lightning.scene.Stage;
import lightning.scene.light.Light;
import org.jspecify.annotations.Nullable;

/**
 * Update of one light's layers over the rows of a level.
 *
 * @param target   the target light
 * @param base     the cached light to start from
 * @param update   the update to apply
 * @param shadows  change of the shapes that cast shadows from this light
 * @param computed the light that its layers were computed for, shadowed by the shapes that shadow it afterwards; null if there are
 *                 no layers
 * @param previous the light in the previous scene with its weight there; null if it did not exist
 * @param gains    change of its gains
 */
public record LayerPlan(WeightedLight target, @Nullable CachedLight base, LightUpdate update, ShapeChange shadows,
        @Nullable WeightedLight computed, @Nullable WeightedLight previous, GainChange gains) {

    /** Change of the light's gains on shapes that stay: of any colors, and of those by which edges are detected. */
    record GainChange(boolean colors, boolean edges) {
        private static final GainChange NONE = new GainChange(false, false);

        static GainChange between(WeightedLight a, WeightedLight b, ShapeChange shapes) {
            return a.gains() == b.gains() ? NONE : new GainChange(!ObjectGains.areSame(a.gains(), b.gains(), shapes),
                    !ObjectGains.areSame(a.forEdges().gains(), b.forEdges().gains(), shapes));
        }
    }

    /**
     * @param known the previous scene
     * @param stage the target shapes
     * @param shapes change to the target shapes
     */
    public static LayerPlan of(WeightedLight target, @Nullable CachedLight from, LightUpdate update, ShapeChange shadows, Scene known,
            Stage stage, ShapeChange shapes) {
        LayerStamp stamp = from == null ? null : from.stamp();
        WeightedLight previous = from == null ? null : WeightedLight.of(from.light(), known);
        return new LayerPlan(target, from, update, shadows, stamp == null ? null
                : WeightedLight.ofSwitchedOn(stamp.light().withShadowsOf(shadowing(target.light(), stamp, update)), known, stage)
                        .withFog(stamp.fog()),
                previous, previous == null ? GainChange.NONE : GainChange.between(previous, target, shapes));
    }

    /** Returns the target light. */
    public Light light() {
        return target.light();
    }

    /**
     * Returns the light whose shadows the updated layer has.
     *
     * @param before stamp of the current layers
     */
    static Light shadowing(Light light, LayerStamp before, LightUpdate update) {
        return update instanceof LightUpdate.Keep ? before.light() : light;
    }

    /**
     * Returns the stamp of the updated layer, or null if there is none.
     *
     * @param minFalloff {@link LayerUpdater#minFalloff} of all threads
     */
    @Nullable
    LayerStamp stamp(UpdateMethod method, double minFalloff) {
        LayerStamp before = base == null ? null : base.stamp();
        return switch (update) {
            case LightUpdate.Keep _ -> before;
            case LightUpdate.FullRecompute _,LightUpdate.Refresh _ -> LayerStamp.ofComputed(target);
            case LightUpdate.Reweight _ -> method.stamp(before, target, true, false, minFalloff);
            case LightUpdate.Partial p -> method.stamp(before, target, p.weight(), p.falloff(), minFalloff);
        };
    }

    /** Returns the layer over one tile's rows before the update; null if there is none. */
    public @Nullable LightLayer layerBefore(TileLevel old) {
        return base == null ? null : base.layer(old);
    }

    /** Returns whether the light's weight changes: color, intensity, gains, on or solo. */
    private boolean changesWeight() {
        return previous == null || gains.colors() || !previous.hasSameWeights(target);
    }

    /** Returns whether this plan alone changes the picture. */
    public boolean changesImage() {
        return changesWeight() || !(update instanceof LightUpdate.Keep) || !shadows.isEmpty();
    }

    /** Returns whether the light may change the colors by which anti-aliasing detects edges in a tile's rows. */
    boolean canChangeEdges(TileLevel old, LightLayer after) {
        return canChange(old, after, changesEdgeWeight());
    }

    private boolean changesEdgeWeight() {
        return previous == null || gains.edges() || !previous.forEdges().hasSameWeights(target.forEdges());
    }

    /** Returns whether the color of any of a tile's rows may change. */
    boolean canChangeColors(TileLevel old, LightLayer after) {
        return canChange(old, after, changesWeight());
    }

    private boolean canChange(TileLevel old, @Nullable LightLayer after, boolean weightChanged) {
        LightLayer before = layerBefore(old);
        boolean lights = before != null && before.litCount() > 0 || after != null && after.litCount() > 0;
        return lights && (before != after || weightChanged);
    }
}
