package lightning.relight.tile;

import java.util.Arrays;
import lightning.cache.CachedTile;
import lightning.cache.TileLevel;
import lightning.engine.Engine;
import lightning.image.Film;
import lightning.relight.plan.Accuracy;
import lightning.relight.plan.MaterialUpdate;
import lightning.scene.Antialias;
import lightning.shading.EdgeCoder;
import lightning.shading.EdgeCodes;
import lightning.shading.TraceCounts;
import lightning.trace.HitRows;
import lightning.trace.RowSplice;
import lightning.trace.SamplePlaces;
import lightning.trace.TileVisibility;
import lightning.trace.Tracer;

/** Builds and updates cached tiles by one engine. Holds scratch memory: one for each thread. */
final class TileWorker {
    private final Job job;
    private final Engine engine;
    private final Tracer tracer;
    private final LevelWorker eye;
    /** Whether rows know whose they are. */
    private final boolean owned;
    /** Made when it is needed first. */
    private LevelWorker mirror;
    /** Made when anti-aliasing asks for it first. */
    private EdgeCoder coder;
    /** Where samples are composed whose colours are not kept; made when it is needed first. */
    private float[][] samples;
    /** The colours composed last. */
    private float[][] colors;
    /** Whether the last tile or block was composed. */
    private boolean recolored;
    private long eyeRays;
    private long mirroredRays;
    private long filmBytes;

    TileWorker(Job job, Engine engine) {
        this.job = job;
        this.engine = engine;
        tracer = engine.tracer(job.shown().geometry());
        eye = new LevelWorker(job, job.shown(), engine, tracer);
        owned = job.owned();
    }

    private LevelWorker mirror() {
        if (mirror == null) {
            mirror = job.mirrored() == job.shown() ? eye : new LevelWorker(job, job.mirrored(), engine, tracer);
        }
        return mirror;
    }

    /** What was done since the start. */
    Tally work() {
        Tally work = new Tally(eye.rowsTouched(), eye.rowsComposed(), eye.bytesMoved() + filmBytes,
                new TraceCounts(eyeRays, mirroredRays, eye.shadowRays()));
        return mirror == null || mirror == eye ? work
                : work.plus(new Tally(mirror.rowsTouched(), mirror.rowsComposed(), mirror.bytesMoved(),
                        new TraceCounts(0, 0, mirror.shadowRays())));
    }

    double leastFalloff() {
        return eye.leastFalloff();
    }

    /** Traces the centres of a tile's pixels and keeps what it learned; null where the work was cancelled. */
    CachedTile firstPass(int tile) {
        int x0 = tile % job.tilesX() * Film.TILE;
        int y0 = tile / job.tilesX() * Film.TILE;
        eyeRays += (long) Math.min(Film.TILE, job.scene().picture().width() - x0)
                * Math.min(Film.TILE, job.scene().picture().height() - y0);
        return traced(SamplePlaces.centers(x0, y0), eye.visibility.eye(x0, y0, Film.TILE, rows(job.coding())), job.coding(), false);
    }

    /** Traces finer samples; null where the work was cancelled. */
    CachedTile fine(SamplePlaces places) {
        eyeRays += places.count();
        return traced(places, eye.visibility.fine(places, rows(false)), false, true);
    }

    /** Whether the samples made last have other colours than before. */
    boolean recolored() {
        return recolored;
    }

    /** The colours of the samples made last, where those are others than before: red, green and blue, valid until the next call. */
    float[][] colors() {
        return colors;
    }

    private CachedTile traced(SamplePlaces places, HitRows rows, boolean coded, boolean fine) {
        TileLevel top = eye.lit(rows);
        begin(coded, top);
        Mirrors mirrors = traced(new TileLevel[] {top}, new int[0][], coded);
        return job.progress().isCancelled() ? null
                : finish(places, top, mirrors, false, null, coded ? coder.codes() : null, fine);
    }

    private TileVisibility.Allocator rows(boolean coded) {
        return (count, textured) -> new HitRows(count, textured, coded, owned);
    }

    /** Updates the centres of a tile's pixels as planned; null where the work was cancelled. */
    CachedTile relight(int tile, CachedTile old) {
        SamplePlaces places = SamplePlaces.centers(tile % job.tilesX() * Film.TILE, tile / job.tilesX() * Film.TILE);
        if (!job.shapes().isEmpty() && eye.visibility.eyeTouches(places, job.shapes().seen())) {
            return firstPass(tile);
        }
        boolean seeksEdges = job.sampling().antialias() == Antialias.EDGES;
        boolean codes = old.codes != null;
        return relight(places, seeksEdges == codes ? old : seeksEdges ? withCodes(places, old) : withoutCodes(old), seeksEdges,
                false);
    }

    /**
     * A tile that anti-aliasing begins to look at: what its rays hit is asked again, for the codes that were not kept; the
     * rows and their light are those that are known.
     */
    private CachedTile withCodes(SamplePlaces places, CachedTile old) {
        TileLevel[] levels = old.levels.clone();
        levels[0] = levels[0].withCode(seen(places, true).code);
        for (int k = 1; k < levels.length; k++) {
            HitRows above = levels[k - 1].rows();
            mirroredRays += above.reflective;
            levels[k] = levels[k].withCode(mirror().visibility.mirrored(above, null, rows(true)).code);
        }
        return new CachedTile(levels, old.hitShapes, old.mirrored, old.film, null);
    }

    /** What the eye rays of some places hit. */
    private HitRows seen(SamplePlaces places, boolean coded) {
        if (places.pixels() != null) {
            eyeRays += places.count();
            return eye.visibility.fine(places, rows(coded));
        }
        eyeRays += (long) Math.min(Film.TILE, job.scene().picture().width() - places.x0())
                * Math.min(Film.TILE, job.scene().picture().height() - places.y0());
        return eye.visibility.eye(places.x0(), places.y0(), Film.TILE, rows(coded));
    }

    /** A tile whose rows know whose they are where a light asks for that, and do not where none does. */
    private CachedTile owned(SamplePlaces places, CachedTile old) {
        boolean known = old.levels[0].rows().owner != null;
        return !owned && !known || owned && known && job.shapes().keepsIndices() ? old
                : new CachedTile(owned ? known ? reindexed(old) : withOwners(places, old) : withoutOwners(old), old.hitShapes,
                        old.mirrored, old.film, old.codes);
    }

    /** What rays hit is asked again: the rows and their light are those that are known. */
    private TileLevel[] withOwners(SamplePlaces places, CachedTile old) {
        TileLevel[] levels = old.levels.clone();
        levels[0] = levels[0].withOwner(seen(places, false).ownersOf(levels[0].rows()));
        for (int k = 1; k < levels.length; k++) {
            HitRows above = levels[k - 1].rows();
            mirroredRays += above.reflective;
            levels[k] = levels[k].withOwner(mirror().visibility.mirrored(above, null, rows(false)).ownersOf(levels[k].rows()));
        }
        return levels;
    }

    private TileLevel[] reindexed(CachedTile old) {
        return Arrays.stream(old.levels).map(level -> level.withOwner(job.shapes().now(level.rows().owner))).toArray(TileLevel[]::new);
    }

    private static TileLevel[] withoutOwners(CachedTile old) {
        return Arrays.stream(old.levels).map(level -> level.withOwner(null)).toArray(TileLevel[]::new);
    }

    private static CachedTile withoutCodes(CachedTile old) {
        TileLevel[] levels = Arrays.stream(old.levels).map(level -> level.withCode(null)).toArray(TileLevel[]::new);
        return new CachedTile(levels, old.hitShapes, old.mirrored, old.film, null);
    }

    /** Updates finer samples as planned; null where the work was cancelled. */
    CachedTile relight(SamplePlaces places, CachedTile old) {
        return !job.shapes().isEmpty() && eye.visibility.eyeTouches(places, job.shapes().seen()) ? fine(places)
                : relight(places, old, false, true);
    }

    /**
     * @param codes whether anti-aliasing looks at these rows
     * @param fine  whether they are finer samples
     */
    private CachedTile relight(SamplePlaces places, CachedTile of, boolean codes, boolean fine) {
        CachedTile old = owned(places, of);
        TileLevel known = old.levels[0];
        MaterialUpdate materials = job.top().plan().materials();
        RowSplice order = materials.mirrors().isIn(known.rows())
                ? RowSplice.sorted(known.rows(), materials.materials()) : null;
        TileLevel sorted = order == null ? known : eye.sorted(order, known);
        sorted = eye.retextured(sorted, null, places, job.top());
        TileLevel top = eye.updated(sorted, job.top());
        if (job.progress().isCancelled()) {
            return null;
        }
        boolean mirrorsStay = job.mirrors() == null && order == null;
        boolean coded = job.coding() && codes && (!mirrorsStay || job.top().recodes(sorted, top.layers()));
        begin(coded, top);
        Mirrors mirrors = mirrorsStay ? new Mirrors(old.levels, old.hitShapes, old.mirrored) : updateMirrors(old, top, order, coded);
        if (job.progress().isCancelled()) {
            return null;
        }
        boolean same = order == null && mirrors.cr == old.mirrored && !job.top().recolors(sorted, top.layers());
        EdgeCodes seen = !coded ? old.codes : (mirrorsStay ? coder.codes(old.codes) : coder.codes()).or(old.codes);
        return finish(places, top, mirrors, same, old.film, seen, fine);
    }

    private void begin(boolean coded, TileLevel top) {
        if (coded) {
            coder = coder == null ? new EdgeCoder() : coder;
            coder.begin();
            eye.code(coder, 0, top);
        }
    }

    private void codeMirrors(boolean coded, TileLevel[] levels, int deepest) {
        for (int k = 1; coded && k <= deepest; k++) {
            mirror().code(coder, k, levels[k]);
        }
    }

    /**
     * Composes the first level, unless its colours are those of before, and puts the tile together.
     *
     * @param film the colours of before
     * @param fine whether the rows are finer samples, whose colours only accuracy ratio keeps, to bound its errors
     */
    private CachedTile finish(SamplePlaces places, TileLevel top, Mirrors mirrors, boolean same, float[][] film, EdgeCodes codes,
            boolean fine) {
        TileLevel[] levels = mirrors.levels.clone();
        levels[0] = top;
        boolean kept = !fine || job.options().accuracy() == Accuracy.RATIO;
        if (!same) {
            colors = kept ? new float[3][Film.TILE_PIXELS] : samples();
            eye.composer.background(top.rows(), job.scene(), places, colors);
            levels[0] = eye.compose(top, job.top(), mirrors.cr, colors);
            filmBytes += kept ? 12L * Film.TILE_PIXELS : 0;
        }
        recolored = !same;
        return new CachedTile(levels, mirrors.hitShapes, mirrors.cr, !kept ? null : same ? film : colors, codes);
    }

    private float[][] samples() {
        samples = samples == null ? new float[3][Film.TILE_PIXELS] : samples;
        return samples;
    }

    /**
     * What a tile keeps of its mirror images.
     *
     * @param levels all levels; only the first where mirror levels are kept as hit shapes
     * @param cr     Cr of the first level's reflective rows, or null where it has none
     */
    private record Mirrors(TileLevel[] levels, int[][] hitShapes, float[][] cr) {}

    /**
     * @param order what became of the first level's rows; null if they are what they were
     * @param coded whether anti-aliasing wants to see the mirror levels
     */
    private Mirrors updateMirrors(CachedTile old, TileLevel top, RowSplice order, boolean coded) {
        if (top.rows().reflective == 0) {
            return new Mirrors(new TileLevel[] {top}, new int[0][], null);
        }
        if (!job.keepsRows()) {
            int[][] hitShapes = Arrays.stream(old.hitShapes).map(job.shapes()::now).toArray(int[][]::new);
            boolean stays = order == null && !crosses(hitShapes);
            int[][] known = stays ? Arrays.copyOf(hitShapes, Math.min(hitShapes.length, job.depth())) : new int[0][];
            return traced(new TileLevel[] {top}, known, coded);
        }
        return spliced(old, top, order, coded);
    }

    /** Whether the rows that are seen in mirrors, known by their shapes alone, are of materials that begin or cease to mirror. */
    private boolean crosses(int[][] hitShapes) {
        if (job.mirrors() == null || job.mirrors().plan().materials().mirrors().isEmpty()) {
            return false;
        }
        for (int[] shapes : hitShapes) {
            for (int shape : shapes) {
                if (shape >= 0 && job.mirrors().plan().materials().mirrors().contains(job.mirrored().geometry().materialOf(shape))) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Updates the levels that are kept as rows: what is known stays, and rays are cast for the rest alone. */
    private Mirrors spliced(CachedTile old, TileLevel top, RowSplice order, boolean coded) {
        TileLevel[] levels = new TileLevel[job.depth() + 1];
        levels[0] = top;
        boolean changed = order != null || job.mirrors() != null && job.mirrors().plan().compose();
        boolean stale = false;
        RowSplice above = order;
        int k = 0;
        for (; k < job.depth() && levels[k].rows().reflective > 0 && !job.progress().isCancelled(); k++) {
            HitRows rows = levels[k].rows();
            TileLevel known = stale || k + 1 >= old.levels.length ? null : old.levels[k + 1];
            if (known != null && mirror().visibility.mirrorsTouch(rows, job.shapes().seen())) {
                // What is seen from these rows may be other rows, and then nothing is known of theirs.
                stale = true;
                known = null;
            }
            if (known == null) {
                levels[k + 1] = mirror().lit(mirror().visibility.mirrored(rows, null, rows(rows.code != null)));
                mirroredRays += rows.reflective;
                changed = true;
                above = null;
                continue;
            }
            RowSplice here = moves(above, known.rows())
                    ? RowSplice.seenFrom(above, rows.reflective, known.rows(), null, job.mirrored().geometry().materials()) : null;
            TileLevel kept = here == null ? known : mirror().sorted(here, known);
            if (job.mirrors() != null) {
                TileLevel textured = mirror().retextured(kept, rows, null, job.mirrors());
                TileLevel updated = mirror().updated(textured, job.mirrors());
                if (job.progress().isCancelled()) {
                    return new Mirrors(levels, old.hitShapes, null);
                }
                changed |= job.mirrors().recolors(textured, updated.layers());
                kept = updated;
            }
            int[] unknown = above == null ? new int[0] : above.unfollowed();
            if (unknown.length > 0) {
                TileLevel added = mirror().lit(mirror().visibility.mirroredFrom(rows, unknown, rows(rows.code != null)));
                mirroredRays += unknown.length;
                RowSplice all = RowSplice.seenFrom(null, rows.reflective, kept.rows(), added.rows(), job.mirrored().geometry().materials());
                kept = mirror().joined(all, kept, added);
                here = here == null ? all : here.then(all);
            }
            levels[k + 1] = kept;
            changed |= here != null;
            above = here;
        }
        if (job.progress().isCancelled()) {
            return new Mirrors(levels, old.hitShapes, null);
        }
        codeMirrors(coded, levels, k);
        levels = Arrays.copyOf(levels, k + 1);
        changed |= k + 1 < old.levels.length;
        return changed ? new Mirrors(levels, old.hitShapes, CachedTile.mirrored(top.rows(), cr(levels, k)))
                : new Mirrors(levels, old.hitShapes, old.mirrored);
    }

    /** Whether rows that are seen from others change their places, or are seen no more. */
    private boolean moves(RowSplice above, HitRows rows) {
        return above != null || job.mirrors() != null && job.mirrors().plan().materials().mirrors().isIn(rows);
    }

    /**
     * Completes the mirror levels to the wanted depth and composes them.
     *
     * @param from  the levels there are, the first included, lit
     * @param known where mirror levels are not kept: the shapes that their rays hit, as far as known
     * @param coded whether anti-aliasing wants to see them
     */
    private Mirrors traced(TileLevel[] from, int[][] known, boolean coded) {
        HitRows top = from[0].rows();
        if (top.reflective == 0) {
            return new Mirrors(from, known, null);
        }
        TileLevel[] levels = Arrays.copyOf(from, job.depth() + 1);
        int[][] shapes = Arrays.copyOf(known, job.depth());
        int deepest = from.length - 1;
        while (deepest < job.depth() && levels[deepest].rows().reflective > 0 && !job.progress().isCancelled()) {
            HitRows above = levels[deepest].rows();
            if (shapes[deepest] != null && mirror().visibility.mirrorsTouch(above, job.shapes().seen())) {
                Arrays.fill(shapes, deepest, shapes.length, null);
            }
            levels[deepest + 1] = mirror().lit(mirror().visibility.mirrored(above, shapes[deepest], rows(above.code != null)));
            if (!job.keepsRows() && shapes[deepest] == null) {
                shapes[deepest] = mirror().visibility.hitShapes(above.reflective);
            }
            mirroredRays += above.reflective;
            deepest++;
        }
        if (job.progress().isCancelled()) {
            return new Mirrors(from, known, null);
        }
        codeMirrors(coded, levels, deepest);
        float[][] cr = CachedTile.mirrored(top, cr(levels, deepest));
        return job.keepsRows()
                ? new Mirrors(Arrays.copyOf(levels, deepest + 1), new int[0][], cr)
                : new Mirrors(Arrays.copyOf(levels, 1), Arrays.copyOf(shapes, deepest), cr);
    }

    /** Composes the mirror levels from the deepest up; the result is Cr of the first level. */
    private float[][] cr(TileLevel[] levels, int deepest) {
        float[][] cr = mirror().composer.unfollowed(levels[deepest].rows());
        for (int k = deepest; k > 0; k--) {
            float[][] above = mirror().composer.followed(levels[k - 1].rows(), job.mirrored().scene().world());
            levels[k] = mirror().compose(levels[k], job.keepsRows() ? job.mirrors() : null, cr, above);
            cr = above;
        }
        return cr;
    }
}
