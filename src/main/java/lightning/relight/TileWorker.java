package lightning.relight;

import java.util.Arrays;
import lightning.cache.CachedTile;
import lightning.cache.TileLevel;
import lightning.image.Film;
import lightning.shading.BranchSums;
import lightning.shading.EdgeCoder;
import lightning.shading.EdgeCodes;
import lightning.shading.Lamp;
import lightning.shading.LightKernel;
import lightning.shading.LightLayer;
import lightning.shading.LightRows;
import lightning.shading.RatioKernel;
import lightning.shading.RatioRows;
import lightning.shading.TileComposer;
import lightning.shading.TraceCounts;
import lightning.trace.HitRows;
import lightning.trace.PacketTracer;
import lightning.trace.TileVisibility;

/** Builds and updates cached tiles. Holds scratch memory: one for each thread. */
final class TileWorker {
    private final Job job;
    private final TileVisibility visibility;
    private final LightKernel lights;
    private final RatioKernel ratios;
    private final LayerUpdater updater;
    private final TileComposer composer;
    private final EdgeCoder coder;
    private long eyeRays;
    private long mirroredRays;
    private long rowsComposed;
    private long bytesMoved;

    TileWorker(Job job) {
        this.job = job;
        PacketTracer tracer = new PacketTracer(job.geometry());
        visibility = new TileVisibility(job.geometry(), job.scene(), tracer);
        lights = new LightKernel(job.geometry(), tracer, job.options().view());
        ratios = new RatioKernel(lights);
        updater = LayerUpdater.of(job.options().accuracy(), lights, ratios);
        composer = new TileComposer(job.geometry().materials(), job.options().view());
        coder = new EdgeCoder(job.geometry().materials());
    }

    TraceCounts rays() {
        return new TraceCounts(eyeRays, mirroredRays, lights.shadowRays());
    }

    long rowsTouched() {
        return lights.rowsTouched() + ratios.rowsScaled();
    }

    double leastFalloff() {
        return ratios.leastFalloff();
    }

    long bytesMoved() {
        return bytesMoved;
    }

    long rowsComposed() {
        return rowsComposed;
    }

    /** Traces the centres of a tile's pixels and keeps what it learned; null where the work was cancelled. */
    CachedTile firstPass(int tile) {
        int x0 = tile % job.tilesX() * Film.TILE;
        int y0 = tile / job.tilesX() * Film.TILE;
        eyeRays += (long) Math.min(Film.TILE, job.scene().picture().width() - x0)
                * Math.min(Film.TILE, job.scene().picture().height() - y0);
        return traced(visibility.eye(x0, y0, Film.TILE, rows(job.coding())), job.coding());
    }

    /**
     * Traces the finer samples of some pixels of a tile; null where the work was cancelled.
     *
     * @param pixels indices in the tile, ascending; those from {@code from} to before {@code to} are meant
     */
    CachedTile fine(int tile, short[] pixels, int from, int to) {
        int x0 = tile % job.tilesX() * Film.TILE;
        int y0 = tile / job.tilesX() * Film.TILE;
        eyeRays += (long) (to - from) * job.sampling().perPixel();
        return traced(visibility.fine(x0, y0, pixels, from, to, job.sampling().grid(), HitRows::new), false);
    }

    private CachedTile traced(HitRows rows, boolean coded) {
        TileLevel top = lit(rows, job.direct());
        begin(coded, top);
        Mirrors mirrors = mirrors(top.rows(), new TileLevel[] {top}, new int[0][], coded);
        return job.progress().isCancelled() ? null : finish(top, mirrors, null, coded ? coder.codes() : null);
    }

    private static TileVisibility.Allocator rows(boolean coded) {
        return (count, textured) -> new HitRows(count, textured, coded);
    }

    /** Updates the centres of a tile's pixels, or finer samples, as planned; null where the work was cancelled. */
    CachedTile relight(CachedTile old) {
        LightLayer[] layers = layers(old.levels[0], job.top());
        TileLevel top = with(old.levels[0], layers, job.top());
        boolean coded = job.coding() && old.codes != null && (job.mirrors() != null || job.top().recodes(old.levels[0], layers));
        if (job.progress().isCancelled()) {
            return null;
        }
        begin(coded, top);
        Mirrors mirrors = job.mirrors() == null
                ? new Mirrors(old.levels, old.hitShapes, old.mirrored)
                : updateMirrors(old, coded);
        if (job.progress().isCancelled()) {
            return null;
        }
        boolean same = mirrors.cr == old.mirrored && !job.top().recolors(old.levels[0], layers);
        EdgeCodes codes = !coded ? old.codes
                : (job.mirrors() == null ? coder.codes(old.codes) : coder.codes()).or(old.codes);
        return finish(top, mirrors, same ? old.film : null, codes);
    }

    private void begin(boolean coded, TileLevel top) {
        if (coded) {
            coder.begin();
            code(0, top, job.direct().lamps());
        }
    }

    /** Hears what anti-aliasing sees of a level. */
    private void code(int k, TileLevel level, Lamp[] lamps) {
        coder.shapes(k, level.rows());
        for (int l = 0; l < lamps.length && !job.progress().isCancelled(); l++) {
            if (!lamps[l].isDark()) {
                coder.light(k, l, level.rows(), switch (level.layers()[l]) {
                    case LightRows exact -> exact;
                    case RatioRows ratio -> ratios.terms(level.rows(), lamps[l], ratio);
                });
            }
        }
    }

    /** Carries out a level's plan on its layers; counts what that reads of the rows and writes. */
    private LightLayer[] layers(TileLevel old, Job.Level plan) {
        LightLayer[] layers = plan.layers(old, updater, job.progress());
        for (int l = 0; l < layers.length; l++) {
            int from = plan.plan().layers().get(l).from();
            LightLayer before = from < 0 ? null : old.layers()[from];
            if (layers[l] != before && layers[l] != null) {
                bytesMoved += layers[l].newBytes(before) + old.rows().count * layers[l].rowBytesRead(before);
            }
        }
        return layers;
    }

    private CachedTile finish(TileLevel top, Mirrors mirrors, float[][] film, EdgeCodes codes) {
        TileLevel[] levels = mirrors.levels.clone();
        levels[0] = top;
        float[][] pixels = film;
        if (pixels == null) {
            pixels = new float[3][Film.TILE_PIXELS];
            levels[0] = compose(top, job.direct(), job.top(), mirrors.cr);
            bytesMoved += 12L * Film.TILE_PIXELS;
            composer.toFilm(top.rows(), job.scene().world(), pixels[0], pixels[1], pixels[2]);
        }
        return new CachedTile(levels, mirrors.hitShapes, mirrors.cr, pixels, codes);
    }

    private TileLevel lit(HitRows rows, Job.Lit lit) {
        LightLayer[] layers = new LightLayer[lit.lamps().length];
        for (int l = 0; l < layers.length && !job.progress().isCancelled(); l++) {
            if (!lit.lamps()[l].isDark()) {
                layers[l] = updater.full(rows, lit.lamps()[l]);
            }
        }
        return new TileLevel(rows, layers);
    }

    /** A level with its layers after an update, and its sums unless they are void. */
    private static TileLevel with(TileLevel level, LightLayer[] layers, Job.Level plan) {
        BranchSums sums = level.branches() != null && level.branches().key() == plan.key() ? level.branches() : null;
        return sums == level.branches() && Arrays.equals(layers, level.layers()) ? level
                : new TileLevel(level.rows(), layers, sums);
    }

    /** Composes a level; gives it back with the sums that are kept for the next time, if any are. */
    private TileLevel compose(TileLevel level, Job.Lit lit, Job.Level plan, float[][] cr) {
        rowsComposed += level.rows().count;
        BranchSums sums = plan == null || plan.key() == null ? null
                : level.branches() != null ? level.branches()
                        : composer.branches(level.rows(), lit.lamps(), level.layers(), plan.key());
        composer.level(level.rows(), lit.lamps(), level.layers(), sums, lit.scene().world(), cr);
        bytesMoved += bytesRead(level, lit.lamps(), plan == null ? null : plan.key(), sums);
        return sums == level.branches() ? level : level.with(sums);
    }

    /** What composing a level reads: textures, mirror images, and of the lights all that light a row, or their sums. */
    private static long bytesRead(TileLevel level, Lamp[] lamps, BranchSums.Key key, BranchSums sums) {
        HitRows rows = level.rows();
        long bytes = 12L * rows.reflective + (rows.diffuseRed == null ? 0 : 12L * rows.count) + 2L * rows.count;
        for (int l = 0; l < lamps.length; l++) {
            boolean read = sums == null || key.light() == l;
            if (read && !lamps[l].isDark() && level.layers()[l].lit() > 0) {
                bytes += level.layers()[l].bytes() - rows.count;
            }
        }
        return bytes + (sums == null ? 0 : sums.bytes());
    }

    /**
     * What a tile keeps of its mirror images.
     *
     * @param levels all levels; only the first where mirror levels are kept as hit shapes
     * @param cr     Cr of the first level's reflective rows, or null where it has none
     */
    private record Mirrors(TileLevel[] levels, int[][] hitShapes, float[][] cr) {}

    private Mirrors updateMirrors(CachedTile old, boolean coded) {
        if (old.rows().reflective == 0) {
            return new Mirrors(old.levels, old.hitShapes, null);
        }
        int keep = Math.min(old.levels.length, job.depth() + 1);
        boolean changed = coded || !job.keepsRows() || keep < old.levels.length
                || old.levels.length <= job.depth() && old.levels[keep - 1].rows().reflective > 0;
        TileLevel[] levels = Arrays.copyOf(old.levels, keep);
        for (int k = 1; k < keep; k++) {
            LightLayer[] layers = layers(old.levels[k], job.mirrors());
            if (job.progress().isCancelled()) {
                return new Mirrors(old.levels, old.hitShapes, old.mirrored);
            }
            changed |= job.mirrors().recolors(old.levels[k], layers);
            levels[k] = with(old.levels[k], layers, job.mirrors());
        }
        changed |= job.mirrors().plan().compose();
        if (!changed) {
            return new Mirrors(levels, old.hitShapes, old.mirrored);
        }
        int[][] known = Arrays.copyOf(old.hitShapes, Math.min(old.hitShapes.length, job.depth()));
        return mirrors(old.rows(), levels, known, coded);
    }

    /**
     * Completes the mirror levels to the wanted depth and composes them.
     *
     * @param from  the levels there are, the first included, lit
     * @param known where mirror levels are not kept: the shapes that their rays hit, as far as known
     * @param coded whether anti-aliasing wants to see them
     */
    private Mirrors mirrors(HitRows top, TileLevel[] from, int[][] known, boolean coded) {
        if (top.reflective == 0) {
            return new Mirrors(from, known, null);
        }
        TileLevel[] levels = Arrays.copyOf(from, job.depth() + 1);
        int[][] shapes = Arrays.copyOf(known, job.depth());
        int deepest = from.length - 1;
        while (deepest < job.depth() && levels[deepest].rows().reflective > 0 && !job.progress().isCancelled()) {
            HitRows above = levels[deepest].rows();
            levels[deepest + 1] = lit(visibility.mirrored(above, shapes[deepest], rows(above.code != null)), job.reflected());
            if (!job.keepsRows() && shapes[deepest] == null) {
                shapes[deepest] = visibility.hitShapes(above.reflective);
            }
            mirroredRays += above.reflective;
            deepest++;
        }
        if (job.progress().isCancelled()) {
            return new Mirrors(from, known, null);
        }
        for (int k = 1; coded && k <= deepest; k++) {
            code(k, levels[k], job.reflected().lamps());
        }
        float[][] cr = copyOf(cr(levels, deepest), top.reflective);
        return job.keepsRows()
                ? new Mirrors(Arrays.copyOf(levels, deepest + 1), new int[0][], cr)
                : new Mirrors(Arrays.copyOf(levels, 1), Arrays.copyOf(shapes, deepest), cr);
    }

    /** Composes the mirror levels from the deepest up; the result is Cr of the first level. */
    private float[][] cr(TileLevel[] levels, int deepest) {
        float[][] cr = composer.unfollowed(levels[deepest].rows());
        for (int k = deepest; k > 0; k--) {
            levels[k] = compose(levels[k], job.reflected(), job.keepsRows() ? job.mirrors() : null, cr);
            cr = composer.followed(levels[k - 1].rows(), levels[k].rows(), job.reflected().scene().world());
        }
        return cr;
    }

    private static float[][] copyOf(float[][] cr, int rows) {
        return new float[][] {Arrays.copyOf(cr[0], rows), Arrays.copyOf(cr[1], rows), Arrays.copyOf(cr[2], rows)};
    }
}
