package lightning.relight.tile;

import java.util.Arrays;
import lightning.cache.TileLevel;
import lightning.shading.BranchSums;
import lightning.shading.EdgeCoder;
import lightning.shading.Lamp;
import lightning.shading.LightKernel;
import lightning.shading.LightLayer;
import lightning.shading.LightRows;
import lightning.shading.RatioKernel;
import lightning.shading.RatioRows;
import lightning.shading.TileComposer;
import lightning.trace.HitRows;
import lightning.trace.PacketTracer;
import lightning.trace.Retexturing;
import lightning.trace.RowSplice;
import lightning.trace.SamplePlaces;
import lightning.trace.TileVisibility;

/**
 * Traces, lights and composes levels that show one scene: those that the eye sees, or those in mirrors. Holds scratch
 * memory: one for each thread.
 */
final class LevelWorker {
    private final Job job;
    private final Job.Shown shown;
    final TileVisibility visibility;
    final TileComposer composer;
    private final PacketTracer tracer;
    /** Made when it is needed first. */
    private Retexturing textures;
    private final LightKernel lights;
    private final RatioKernel ratios;
    private final LayerUpdater updater;
    private long rowsComposed;
    private long bytesMoved;

    LevelWorker(Job job, Job.Shown shown, PacketTracer tracer) {
        this.job = job;
        this.shown = shown;
        this.tracer = tracer;
        visibility = new TileVisibility(shown.geometry(), shown.scene(), tracer);
        lights = new LightKernel(shown.geometry(), tracer, job.options().view());
        ratios = new RatioKernel(lights);
        updater = LayerUpdater.of(job.options().accuracy(), lights, ratios);
        composer = new TileComposer(shown.geometry().materials(), job.options().view());
    }

    long shadowRays() {
        return lights.shadowRays();
    }

    long rowsTouched() {
        return lights.rowsTouched() + ratios.rowsScaled() + (textures == null ? 0 : textures.rowsTouched());
    }

    double leastFalloff() {
        return ratios.leastFalloff();
    }

    long rowsComposed() {
        return rowsComposed;
    }

    long bytesMoved() {
        return bytesMoved;
    }

    /** The layers of all lights that shine, from nothing. */
    TileLevel lit(HitRows rows) {
        LightLayer[] layers = new LightLayer[shown.lamps().length];
        for (int l = 0; l < layers.length && !job.progress().isCancelled(); l++) {
            if (!shown.lamps()[l].isDark()) {
                layers[l] = updater.full(rows, shown.lamps()[l]);
            }
        }
        return new TileLevel(rows, layers);
    }

    /**
     * The level with the texels that the plan's materials ask for.
     *
     * @param above  the level that it is seen from; null for the first
     * @param places where the rays of the first level go; unread for others
     */
    TileLevel retextured(TileLevel level, HitRows above, SamplePlaces places, Job.Level plan) {
        var changed = plan.plan().materials().retextured();
        if (changed.isEmpty()) {
            return level;
        }
        if (textures == null) {
            textures = new Retexturing(shown.geometry(), shown.scene(), tracer);
        }
        HitRows rows = above == null ? textures.eye(level.rows(), places, changed)
                : textures.mirrored(level.rows(), above, changed);
        if (rows == level.rows()) {
            return level;
        }
        bytesMoved += 12L * rows.count + (12L + 36) * changed.countIn(rows);
        return new TileLevel(rows, level.layers());
    }

    /** Carries out a plan on a level's layers; counts what that reads of the rows and writes. */
    TileLevel updated(TileLevel old, Job.Level plan) {
        LightLayer[] layers = plan.layers(old, updater, job.progress());
        for (int l = 0; l < layers.length; l++) {
            int from = plan.plan().layers().get(l).from();
            LightLayer before = from < 0 ? null : old.layers()[from];
            if (layers[l] != before && layers[l] != null) {
                bytesMoved += layers[l].newBytes(before) + old.rows().count * layers[l].rowBytesRead(before);
            }
        }
        BranchSums sums = old.branches() != null && old.branches().key() == plan.key() ? old.branches() : null;
        return sums == old.branches() && Arrays.equals(layers, old.layers()) ? old : new TileLevel(old.rows(), layers, sums);
    }

    /**
     * A level over rows that were put together anew.
     *
     * @param added rows newly lit by {@link #lit}, with their layers; null for none. A layer that either level lacks is
     *              dropped: its light does not shine, and once it does the layer is made anew.
     */
    TileLevel spliced(RowSplice splice, TileLevel old, TileLevel added) {
        if (splice.keepsRows()) {
            return new TileLevel(splice.rows(), old.layers());
        }
        LightLayer[] layers = new LightLayer[old.layers().length];
        for (int l = 0; l < layers.length; l++) {
            LightLayer before = old.layers()[l];
            LightLayer more = added == null ? null : added.layers()[l];
            if (before != null && (added == null || more != null)) {
                layers[l] = updater.spliced(splice, before, more, added == null ? null : shown.lamps()[l]);
            }
        }
        var level = new TileLevel(splice.rows(), layers);
        bytesMoved += old.bytes() + level.bytes();
        return level;
    }

    /** Tells anti-aliasing what a level shows; the levels above were told before. */
    void code(EdgeCoder coder, int k, TileLevel level) {
        Lamp[] lamps = shown.lamps();
        coder.shapes(k, level.rows(), shown.geometry().materials());
        for (int l = 0; l < lamps.length && !job.progress().isCancelled(); l++) {
            if (!lamps[l].isDark()) {
                LightRows layer = switch (level.layers()[l]) {
                    case LightRows exact -> exact;
                    case RatioRows ratio -> ratios.terms(level.rows(), lamps[l], ratio);
                };
                coder.light(k, l, level.rows(), layer, shown.geometry().materials());
            }
        }
    }

    /** Composes a level; gives it back with the sums that are kept for the next time, if any are. */
    TileLevel compose(TileLevel level, Job.Level plan, float[][] cr) {
        rowsComposed += level.rows().count;
        BranchSums sums = plan == null || plan.key() == null ? null
                : level.branches() != null ? level.branches()
                : composer.branches(level.rows(), shown.lamps(), level.layers(), plan.key());
        composer.level(level.rows(), shown.lamps(), level.layers(), sums, shown.scene().world(), cr);
        bytesMoved += bytesRead(level, plan == null ? null : plan.key(), sums);
        return sums == level.branches() ? level : level.with(sums);
    }

    /** What composing a level reads: textures, mirror images, and of the lights all that light a row, or their sums. */
    private long bytesRead(TileLevel level, BranchSums.Key key, BranchSums sums) {
        HitRows rows = level.rows();
        long bytes = 12L * rows.reflective + (rows.texelRed == null ? 0 : 12L * rows.count) + 2L * rows.count;
        for (int l = 0; l < shown.lamps().length; l++) {
            boolean read = sums == null || key.light() == l;
            if (read && !shown.lamps()[l].isDark() && level.layers()[l].lit() > 0) {
                bytes += level.layers()[l].bytes() - rows.count;
            }
        }
        return bytes + (sums == null ? 0 : sums.bytes());
    }
}
