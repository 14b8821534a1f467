package lightning.render.relight.plan;

import static java.util.Objects.requireNonNull;

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
 * @param changesGains whether its gains on shapes that stay change
 */
public record LayerPlan(WeightedLight target, @Nullable CachedLight base, LightUpdate update, ShapeChange shadows,
        @Nullable WeightedLight computed, @Nullable WeightedLight previous, boolean changesGains) {

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
                previous,
                previous != null && previous.gains() != target.gains() && !ObjectGains.areSame(previous.gains(), target.gains(), shapes));
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
        return previous == null || changesGains || !previous.hasSameWeights(target);
    }

    /** Returns whether nothing but the weight of a light with layers changes. @param index of the light */
    boolean onlyReweights(int index) {
        return base != null && base.index() == index && shadows.isEmpty() && !changesGains
                && (target.isDark() || !requireNonNull(previous).isDark())
                && (update instanceof LightUpdate.Keep || update instanceof LightUpdate.Reweight);
    }

    /** Returns whether this plan alone changes the picture. */
    public boolean changesImage() {
        return changesWeight() || !(update instanceof LightUpdate.Keep) || !shadows.isEmpty();
    }
}
