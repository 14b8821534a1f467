package lightning.render.relight.tile;

import java.util.Arrays;
import java.util.BitSet;
import java.util.function.Function;
import lightning.render.cache.TileLevel;
import lightning.render.engine.Engine;
import lightning.render.relight.plan.LayerPlan;
import lightning.render.relight.plan.LayerUpdater;
import lightning.render.relight.plan.LevelPlan;
import lightning.render.relight.plan.LightUpdate;
import lightning.render.shading.BranchSums;
import lightning.render.shading.EdgeCoder;
import lightning.render.shading.Images;
import lightning.render.shading.LightKernel;
import lightning.render.shading.LightLayer;
import lightning.render.shading.LightRows;
import lightning.render.shading.Luminaire;
import lightning.render.shading.TileComposer;
import lightning.render.trace.Bounce;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialSet;
import lightning.render.trace.Retexturing;
import lightning.render.trace.RowSplice;
import lightning.render.trace.SamplePlaces;
import lightning.render.trace.TileVisibility;
import lightning.render.trace.Tracer;

/**
 * Traces, lights and composes levels that show one scene: those that the eye sees, or those in mirrors. Holds scratch
 * memory: one for each thread.
 */
final class LevelWorker {
    /** With a larger share of rays traced anew, putting rows together takes what it spares (figures: docs/performance.md). */
    private static final double MOST_ANEW = 0.25;

    private final Job job;
    private final PreparedScene shown;
    /** Made when rays are traced first. */
    private TileVisibility visibility;
    final TileComposer composer;
    private final Tracer tracer;
    /** Made when it is needed first. */
    private Retexturing textures;
    private final LightKernel lights;
    private final LayerUpdater updater;
    private long rowsComposed;
    private long bytesMoved;

    LevelWorker(Job job, PreparedScene shown, Engine engine, Tracer tracer) {
        this.job = job;
        this.shown = shown;
        this.tracer = tracer;
        lights = new LightKernel(shown.geometry(), tracer, engine.terms(), job.options().view());
        updater = job.options().method().updater(lights, shown.lights().length);
        composer = new TileComposer(shown.geometry().materials(), engine.sums(), job.options().view());
    }

    /** Whether so few of some rays are traced anew that what the others hit is worth keeping. */
    static boolean areFew(BitSet anew, int rays) {
        return anew.cardinality() <= MOST_ANEW * rays;
    }

    /** What traces the rays of tiles and levels. */
    TileVisibility visibility() {
        visibility = visibility == null ? new TileVisibility(shown.geometry(), shown.scene(), tracer) : visibility;
        return visibility;
    }

    long shadowRays() {
        return lights.shadowRays();
    }

    long rowsTouched() {
        return updater.rowsTouched() + (textures == null ? 0 : textures.rowsTouched());
    }

    double leastFalloff() {
        return updater.leastFalloff();
    }

    long rowsComposed() {
        return rowsComposed;
    }

    long bytesMoved() {
        return bytesMoved;
    }

    /** The layers of all lights that shine, from nothing. */
    TileLevel lit(HitRows traced) {
        HitRows rows = traced.compact();
        LightLayer[] layers = new LightLayer[shown.lights().length];
        for (int l = 0; l < layers.length && !job.progress().isCancelled(); l++) {
            if (!shown.lights()[l].isDark()) {
                layers[l] = updater.full(rows, shown.lights()[l]);
            }
        }
        return new TileLevel(rows, layers);
    }

    /**
     * The first level with the texels that the plan's materials ask for.
     *
     * @param places where its rays go
     */
    TileLevel retextured(TileLevel level, SamplePlaces places, LevelPlan update) {
        return retextured(level, update, t -> t.eye(level.rows(), places, update.materials().retextured()));
    }

    /**
     * Another level with the texels that the plan's materials ask for.
     *
     * @param above the level that it is seen from
     */
    TileLevel retextured(TileLevel level, HitRows above, Bounce bounce, LevelPlan update) {
        return retextured(level, update, t -> t.seenFrom(level.rows(), above, bounce, update.materials().retextured()));
    }

    private TileLevel retextured(TileLevel level, LevelPlan update, Function<Retexturing, HitRows> look) {
        var changed = update.materials().retextured();
        if (changed.isEmpty()) {
            return level;
        }
        if (textures == null) {
            textures = new Retexturing(shown.geometry(), shown.scene(), tracer);
        }
        HitRows rows = look.apply(textures);
        if (rows == level.rows()) {
            return level;
        }
        bytesMoved += 12L * rows.count + (12L + 36) * changed.countIn(rows);
        return new TileLevel(rows, level.layers());
    }

    /** Carries out a plan on a level's layers; counts what that reads of the rows and writes. */
    TileLevel updated(TileLevel old, LevelPlan update) {
        LightLayer[] layers = new LightLayer[update.layers().size()];
        for (int l = 0; l < layers.length && !job.progress().isCancelled(); l++) {
            layers[l] = updated(old, update.layers().get(l), update.materials().speculars());
        }
        for (int l = 0; l < layers.length; l++) {
            LightLayer before = update.layers().get(l).before(old);
            if (layers[l] != before && layers[l] != null) {
                bytesMoved += layers[l].newBytes(before) + old.rows().count * layers[l].rowBytesRead(before);
            }
        }
        BranchSums sums = old.branches() != null && old.branches().key() == update.key() ? old.branches() : null;
        return sums == old.branches() && Arrays.equals(layers, old.layers()) ? old : new TileLevel(old.rows(), layers, sums);
    }

    /**
     * A light's layer over a level's rows after its update: that before where nothing of it changes; null where it never shone.
     *
     * @param speculars materials whose specular term changed
     */
    private LightLayer updated(TileLevel old, LayerPlan plan, MaterialSet speculars) {
        LightLayer before = plan.before(old);
        if (before == null) {
            // Never lit, or a mirror level that a deeper recursion added while the light was dark.
            return plan.wanted().isDark() ? null : updater.full(old.rows(), plan.wanted());
        }
        if (plan.update() instanceof LightUpdate.FullRecompute) {
            return updater.full(old.rows(), plan.wanted());
        }
        if (plan.wanted().isDark() && !plan.shadows().isEmpty()
                && lights.mayChange(old.rows(), plan.computed().lamp(), before, plan.shadows())) {
            // Made anew once it shines.
            return null;
        }
        return updater.update(old.rows(), before, plan, speculars);
    }

    /** A level over rows of which some may be gone, in another order; its layers are of the lights that they were of before. */
    TileLevel sorted(RowSplice splice, TileLevel old) {
        return splice.keepsRows() ? new TileLevel(splice.rows(), old.layers())
                : moved(old, splice.rows(), Arrays.stream(old.layers())
                        .map(before -> before == null ? null : updater.sorted(splice, before)).toArray(LightLayer[]::new));
    }

    /**
     * A level over rows that were put together of known ones and others.
     *
     * @param old   layers of the lights shown over the known rows
     * @param added rows newly lit by {@link #lit}, with their layers. A layer that either level lacks is dropped: its light does
     *              not shine, and once it does the layer is made anew.
     */
    TileLevel joined(RowSplice splice, TileLevel old, TileLevel added) {
        LightLayer[] layers = new LightLayer[old.layers().length];
        for (int l = 0; l < layers.length; l++) {
            LightLayer before = old.layers()[l];
            LightLayer more = added.layers()[l];
            layers[l] = before == null || more == null ? null : updater.joined(splice, before, more, shown.lights()[l]);
        }
        return moved(old, splice.rows().compact(), layers);
    }

    private TileLevel moved(TileLevel old, HitRows rows, LightLayer[] layers) {
        var level = new TileLevel(rows, layers);
        bytesMoved += old.bytes() + level.bytes();
        return level;
    }

    /** Tells anti-aliasing what a level shows; the levels above were told before. */
    void code(EdgeCoder coder, int depth, int place, TileLevel level) {
        Luminaire[] shining = shown.lights();
        coder.shapes(depth, place, level.rows(), shown.geometry().materials());
        for (int l = 0; l < shining.length && !job.progress().isCancelled(); l++) {
            if (!shining[l].isDark()) {
                LightRows layer = updater.terms(level.rows(), shining[l], level.layers()[l]);
                coder.light(depth, place, l, level.rows(), layer, shown.geometry().materials());
            }
        }
    }

    /**
     * Composes a level; gives it back with the sums that are kept for the next time, if any are.
     *
     * @param to gets the colours
     */
    TileLevel compose(TileLevel level, LevelPlan update, Images images, float[][] to) {
        rowsComposed += level.rows().count;
        BranchSums sums = update == null || update.key() == null ? null
                : level.branches() != null ? level.branches()
                : composer.branches(level.rows(), shown.lights(), level.layers(), update.key());
        composer.level(level.rows(), shown.lights(), level.layers(), sums, shown.scene().world(), images, to);
        bytesMoved += bytesRead(level, update == null ? null : update.key(), sums);
        return sums == level.branches() ? level : level.with(sums);
    }

    /** What composing a level reads: textures, mirror images, and of the lights all that light a row, or their sums. */
    private long bytesRead(TileLevel level, BranchSums.Key key, BranchSums sums) {
        HitRows rows = level.rows();
        long bytes = 12L * (rows.reflective + rows.clear) + (rows.texelRed == null ? 0 : 12L * rows.count) + 2L * rows.count;
        for (int l = 0; l < shown.lights().length; l++) {
            boolean read = sums == null || key.light() == l;
            if (read && !shown.lights()[l].isDark() && level.layers()[l].lit() > 0) {
                bytes += level.layers()[l].composedBytes();
            }
        }
        return bytes + (sums == null ? 0 : sums.bytes());
    }
}
