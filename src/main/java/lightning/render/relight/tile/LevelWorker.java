package lightning.render.relight.tile;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.BitSet;
import java.util.Map;
import java.util.function.Function;
import lightning.render.cache.TileLevel;
import lightning.render.engine.Engine;
import lightning.render.gather.RowWeigher;
import lightning.render.gather.RowWeights;
import lightning.render.relight.plan.LayerPlan;
import lightning.render.relight.plan.LayerUpdater;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.shading.layer.LightKernel;
import lightning.render.shading.layer.LightLayer;
import lightning.render.trace.BounceKind;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.RowSplice;
import lightning.render.trace.SamplePositions;
import lightning.render.trace.TexelUpdater;
import lightning.render.trace.TileVisibility;
import lightning.render.trace.Tracer;
import org.jspecify.annotations.Nullable;

/**
 * Traces and lights the levels that show one scene: those seen directly, or those in mirrors. Holds scratch memory: use
 * one instance per thread.
 */
final class LevelWorker {
    /** With a larger share of retraced rays, splicing rows costs as much as it saves (figures: docs/performance.md). */
    private static final double MAX_RETRACED_SHARE = 0.25;

    private final RenderJob job;
    private final PreparedScene target;
    /** Created for the first trace. */
    private @Nullable TileVisibility visibility;
    private final Tracer tracer;
    /** Created on first use. */
    private @Nullable TexelUpdater retexturing;
    private final LightKernel lightKernel;
    private final LayerUpdater updater;
    /** Created on first use. */
    private @Nullable RowWeigher weigher;
    private long bytesMoved;

    LevelWorker(RenderJob job, PreparedScene shown, Engine engine, Tracer tracer) {
        this(job, shown, engine, tracer, new LightKernel(shown.geometry(), tracer, engine.terms(), job.options().view()));
    }

    /**
     * Returns a worker for surfels.
     *
     * @param shines whether reflections show their highlights
     */
    static LevelWorker forSurfels(RenderJob job, Engine engine, boolean shines) {
        PreparedScene shown = job.target();
        Tracer tracer = engine.tracer(shown.geometry());
        return new LevelWorker(job, shown, engine, tracer,
                LightKernel.forSurfels(shown.geometry(), tracer, engine.terms(), job.options().view(), shines));
    }

    private LevelWorker(RenderJob job, PreparedScene shown, Engine engine, Tracer tracer, LightKernel kernel) {
        this.job = job;
        this.target = shown;
        this.tracer = tracer;
        lightKernel = kernel;
        updater = job.options().method().updater(lightKernel, shown.lights().length);
    }

    /** Returns whether few enough rays are retraced for keeping the hits of the others to pay off. */
    static boolean isWorthUpdating(BitSet retraced, int rays) {
        return retraced.cardinality() <= MAX_RETRACED_SHARE * rays;
    }

    /** Returns the tracer of tiles and levels. */
    TileVisibility visibility() {
        visibility = visibility == null ? new TileVisibility(target.geometry(), target.scene(), tracer) : visibility;
        return visibility;
    }

    long shadowRayCount() {
        return lightKernel.shadowRayCount();
    }

    Map<String, Long> shadowRays() {
        return lightKernel.shadowRays();
    }

    long rowsTouched() {
        return updater.rowsTouched() + (retexturing == null ? 0 : retexturing.rowsTouched());
    }

    double minFalloff() {
        return updater.minFalloff();
    }

    long bytesMoved() {
        return bytesMoved;
    }

    /** Computes the layers of all lights that shine from nothing. */
    TileLevel lightLevel(HitRows traced) {
        HitRows rows = traced.compact();
        LightLayer[] layers = new LightLayer[target.lights().length];
        for (int l = 0; l < layers.length && !job.progress().isCanceled(); l++) {
            if (!target.lights()[l].isDark()) {
                layers[l] = updater.recompute(rows, target.lights()[l]);
            }
        }
        return new TileLevel(rows, layers);
    }

    /** Returns a level with the weights of gather points, if the scene has indirect light. */
    TileLevel withWeights(TileLevel level) {
        if (target.indirect() == null || level.hasWeightsOf(target.indirect().structure())) {
            return level;
        }
        weigher = weigher == null ? new RowWeigher(target.indirect().structure()) : weigher;
        RowWeights kept = target.pointChanges() == null || level.weights() == null ? null
                : target.pointChanges().keep(level.weights(), level.rows(), weigher);
        return level.withWeights(kept != null ? kept : weigher.weigh(level.rows()));
    }

    /**
     * Returns the first level with the texels of the plan's materials.
     *
     * @param places sample positions of its rays
     */
    TileLevel retexture(TileLevel level, SamplePositions places, LevelPlan update) {
        return retexture(level, update, t -> t.updateEyeRows(level.rows(), places, update.materials().textureChanged()));
    }

    /**
     * Returns a bounce level with the texels of the plan's materials.
     *
     * @param above the level that it is seen from
     */
    TileLevel retexture(TileLevel level, HitRows above, BounceKind bounce, LevelPlan update) {
        return retexture(level, update, t -> t.updateBounceRows(level.rows(), above, bounce, update.materials().textureChanged()));
    }

    private TileLevel retexture(TileLevel level, LevelPlan update, Function<TexelUpdater, HitRows> look) {
        var changed = update.materials().textureChanged();
        if (changed.isEmpty()) {
            return level;
        }
        if (retexturing == null) {
            retexturing = new TexelUpdater(target.geometry(), target.scene(), tracer);
        }
        HitRows rows = look.apply(retexturing);
        if (rows == level.rows()) {
            return level;
        }
        bytesMoved += 12L * rows.count + (12L + 36) * changed.countIn(rows);
        return new TileLevel(rows, level.layers()).withWeights(level.weights());
    }

    /** Applies a plan to a level's layers; counts the row data read and the layer data written. */
    TileLevel update(TileLevel old, LevelPlan update) {
        LightLayer[] layers = new LightLayer[update.layers().size()];
        for (int l = 0; l < layers.length && !job.progress().isCanceled(); l++) {
            layers[l] = update(old, update.layers().get(l), update.materials().specularChanged());
        }
        for (int l = 0; l < layers.length; l++) {
            LightLayer before = update.layers().get(l).layerBefore(old);
            if (layers[l] != before && layers[l] != null) {
                bytesMoved += layers[l].newBytes(before) + old.rows().count * layers[l].rowBytesRead(before);
            }
        }
        return Arrays.equals(layers, old.layers()) ? old : new TileLevel(old.rows(), layers, old.weights(), old.fog());
    }

    /**
     * Returns a light's layer over a level's rows after its update: the old layer if nothing changes; null if the light never
     * shone.
     *
     * @param speculars materials whose specular term changed
     */
    private @Nullable LightLayer update(TileLevel old, LayerPlan plan, MaterialSet speculars) {
        LightLayer before = plan.layerBefore(old);
        if (before == null) {
            // Never lit, or a mirror level that a larger depth added while the light was dark.
            return plan.target().isDark() ? null : updater.recompute(old.rows(), plan.target());
        }
        if (plan.update() instanceof LightUpdate.FullRecompute) {
            return updater.recompute(old.rows(), plan.target());
        }
        if (plan.target().isDark() && !plan.shadows().isEmpty()
                && lightKernel.canShadowsChange(old.rows(), requireNonNull(plan.computed()).source(), before, plan.shadows())) {
            // Recomputed once the light shines.
            return null;
        }
        return updater.update(old.rows(), before, plan, speculars);
    }

    /** Returns a level with reordered rows, some of which may be removed, and layers of the same lights. */
    TileLevel reorder(RowSplice splice, TileLevel old) {
        return splice.isUnchanged() ? new TileLevel(splice.rows(), old.layers())
                : replaceRows(old, splice.rows(), Arrays.stream(old.layers())
                        .map(before -> before == null ? null : updater.reorder(splice, before)).toArray(LightLayer[]::new));
    }

    /**
     * Returns a level spliced from cached rows and new ones.
     *
     * @param old   layers of the shown lights over the cached rows
     * @param added rows newly lit by {@link #lightLevel}, with their layers. A layer that either level lacks is dropped: its light
     *              does not shine, and the layer is recomputed once it does.
     */
    TileLevel join(RowSplice splice, TileLevel old, TileLevel added) {
        LightLayer[] layers = new LightLayer[old.layers().length];
        for (int l = 0; l < layers.length; l++) {
            LightLayer before = old.layers()[l];
            LightLayer addedLayer = added.layers()[l];
            layers[l] = before == null || addedLayer == null ? null : updater.join(splice, before, addedLayer, target.lights()[l]);
        }
        return replaceRows(old, splice.rows().compact(), layers);
    }

    private TileLevel replaceRows(TileLevel old, HitRows rows, LightLayer[] layers) {
        var level = new TileLevel(rows, layers);
        bytesMoved += old.bytes() + level.bytes();
        return level;
    }

    /**
     * Returns a level with the terms of the lights that shine, for {@link PreparedScene#edgeParts}. It casts no ray, so it does not
     * ask for cancellation: the caller composes all terms.
     */
    TileLevel withTerms(TileLevel level) {
        LightLayer[] terms = new LightLayer[target.lights().length];
        for (int l = 0; l < terms.length; l++) {
            terms[l] = target.lights()[l].isDark() ? null : updater.terms(level.rows(), target.lights()[l], level.layers()[l]);
        }
        return new TileLevel(level.rows(), terms).withWeights(withWeights(level).weights());
    }
}
