package lightning.render.relight.tile;

import java.util.Arrays;
import java.util.BitSet;
import lightning.render.cache.CachedTile;
import lightning.render.cache.TileLevel;
import lightning.render.engine.Engine;
import lightning.render.image.Film;
import lightning.render.relight.plan.MaterialUpdate;
import lightning.render.shading.EdgeCoder;
import lightning.render.shading.EdgeCodes;
import lightning.render.shading.TraceCounts;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowSplice;
import lightning.render.trace.SamplePlaces;
import lightning.render.trace.TileVisibility;
import lightning.render.trace.Tracer;
import lightning.scene.Antialias;

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
    /** Made when it is needed first. */
    private LowerLevels lower;
    /** Made when anti-aliasing asks for it first. */
    private EdgeCoder coder;
    /** Where samples are composed whose colours are not kept; made when it is needed first. */
    private float[][] samples;
    /** The colours composed last. */
    private float[][] colors;
    /** Whether the last tile or block was composed. */
    private boolean recolored;
    private long eyeRays;
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

    private LowerLevels lower() {
        lower = lower == null ? new LowerLevels(job, mirror()) : lower;
        return lower;
    }

    /** What was done since the start. */
    Tally work() {
        Tally work = new Tally(eye.rowsTouched(), eye.rowsComposed(), eye.bytesMoved() + filmBytes,
                new TraceCounts(eyeRays, lower == null ? 0 : lower.rays(), eye.shadowRays()));
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
        return traced(SamplePlaces.centers(x0, y0), eye.visibility().eye(x0, y0, Film.TILE, rows(job.coding())), job.coding(), false);
    }

    /** Traces finer samples; null where the work was cancelled. */
    CachedTile fine(SamplePlaces places) {
        eyeRays += places.count();
        return traced(places, eye.visibility().fine(places, rows(false)), false, true);
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
        LowerLevels.Kept below = top.rows().reflective == 0 ? new LowerLevels.Kept(new TileLevel[] {top}, new int[0][], null)
                : lower().traced(top, new int[0][], coded ? coder : null);
        return job.progress().isCancelled() ? null
                : finish(places, top, below, false, null, coded ? coder.codes() : null, fine);
    }

    private TileVisibility.Allocator rows(boolean coded) {
        return (count, textured, clear) -> new HitRows(count, textured, clear, coded, owned);
    }

    /** Updates the centres of a tile's pixels as planned; null where the work was cancelled. */
    CachedTile relight(int tile, CachedTile old) {
        SamplePlaces places = SamplePlaces.centers(tile % job.tilesX() * Film.TILE, tile / job.tilesX() * Film.TILE);
        BitSet anew = touching(places);
        if (!LevelWorker.areFew(anew, places.count())) {
            return firstPass(tile);
        }
        boolean seeksEdges = job.sampling().antialias() == Antialias.EDGES;
        boolean codes = old.codes != null;
        return relight(places, seeksEdges == codes ? old : seeksEdges ? withCodes(places, old) : withoutCodes(old), anew, seeksEdges,
                false);
    }

    /** Those of the places whose rays may hit something else than before. */
    private BitSet touching(SamplePlaces places) {
        return job.shapes().isEmpty() ? new BitSet() : eye.visibility().eyeTouching(places, job.shapes().seen());
    }

    /**
     * A tile that anti-aliasing begins to look at: what its rays hit is asked again, for the codes that were not kept; the
     * rows and their light are those that are known.
     */
    private CachedTile withCodes(SamplePlaces places, CachedTile old) {
        TileLevel top = old.levels[0].withCode(seen(places, true).code);
        TileLevel[] levels = lower().asked(old, top, true, (level, again) -> level.withCode(again.code));
        return new CachedTile(levels, old.hitShapes, old.images, old.film, null);
    }

    /** What the eye rays of some places hit. */
    private HitRows seen(SamplePlaces places, boolean coded) {
        if (places.pixels() != null) {
            eyeRays += places.count();
            return eye.visibility().fine(places, rows(coded));
        }
        eyeRays += (long) Math.min(Film.TILE, job.scene().picture().width() - places.x0())
                * Math.min(Film.TILE, job.scene().picture().height() - places.y0());
        return eye.visibility().eye(places.x0(), places.y0(), Film.TILE, rows(coded));
    }

    /** A tile whose rows know whose they are where a light asks for that, and do not where none does. */
    private CachedTile owned(SamplePlaces places, CachedTile old) {
        boolean known = old.levels[0].rows().owner != null;
        return !owned && !known || owned && known && job.shapes().keepsIndices() ? old
                : new CachedTile(owned ? known ? reindexed(old) : withOwners(places, old) : withoutOwners(old), old.hitShapes,
                        old.images, old.film, old.codes);
    }

    /** What rays hit is asked again: the rows and their light are those that are known. */
    private TileLevel[] withOwners(SamplePlaces places, CachedTile old) {
        TileLevel top = old.levels[0].withOwner(seen(places, false).ownersOf(old.levels[0].rows()));
        return lower().asked(old, top, false, (level, again) -> level.withOwner(again.ownersOf(level.rows())));
    }

    private TileLevel[] reindexed(CachedTile old) {
        return Arrays.stream(old.levels).map(level -> level.withOwner(job.shapes().now(level.rows().owner))).toArray(TileLevel[]::new);
    }

    private static TileLevel[] withoutOwners(CachedTile old) {
        return Arrays.stream(old.levels).map(level -> level.withOwner(null)).toArray(TileLevel[]::new);
    }

    private static CachedTile withoutCodes(CachedTile old) {
        TileLevel[] levels = Arrays.stream(old.levels).map(level -> level.withCode(null)).toArray(TileLevel[]::new);
        return new CachedTile(levels, old.hitShapes, old.images, old.film, null);
    }

    /** Updates finer samples as planned; null where the work was cancelled. */
    CachedTile relight(SamplePlaces places, CachedTile old) {
        BitSet anew = touching(places);
        return LevelWorker.areFew(anew, places.count()) ? relight(places, old, anew, false, true) : fine(places);
    }

    /**
     * @param anew  places whose rays are traced anew
     * @param codes whether anti-aliasing looks at these rows
     * @param fine  whether they are finer samples
     */
    private CachedTile relight(SamplePlaces places, CachedTile of, BitSet anew, boolean codes, boolean fine) {
        CachedTile old = owned(places, of);
        TileLevel known = old.levels[0];
        MaterialUpdate materials = job.top().materials();
        RowSplice order = !anew.isEmpty() || materials.mirrors().isIn(known.rows())
                ? RowSplice.sorted(known.rows(), anew, job.shown().geometry().materials()) : null;
        TileLevel sorted = order == null ? known : eye.sorted(order, known);
        sorted = eye.retextured(sorted, places, job.top());
        TileLevel top = eye.updated(sorted, job.top());
        if (!anew.isEmpty() && !job.progress().isCancelled()) {
            TileLevel added = eye.lit(eye.visibility().eye(places, anew, rows(known.rows().code != null)));
            eyeRays += anew.cardinality();
            RowSplice all = RowSplice.joined(Film.TILE_PIXELS, top.rows(), added.rows(), job.shown().geometry().materials());
            top = eye.joined(all, top, added);
            order = order.then(all);
        }
        if (job.progress().isCancelled()) {
            return null;
        }
        boolean lowerStay = job.mirrors() == null && order == null;
        boolean coded = job.coding() && codes && (!lowerStay || job.top().recodes(sorted, top.layers()));
        begin(coded, top);
        LowerLevels.Kept below =
                lowerStay ? new LowerLevels.Kept(old.levels, old.hitShapes, old.images) : updateLower(old, top, order, coded);
        if (job.progress().isCancelled()) {
            return null;
        }
        boolean same = order == null && below.images() == old.images && !job.top().recolors(sorted, top.layers());
        EdgeCodes seen = !coded ? old.codes : (lowerStay ? coder.codes(old.codes) : coder.codes()).or(old.codes);
        return finish(places, top, below, same, old.film, seen, fine);
    }

    private void begin(boolean coded, TileLevel top) {
        if (coded) {
            coder = coder == null ? new EdgeCoder() : coder;
            coder.begin();
            eye.code(coder, 0, 0, top);
        }
    }

    /**
     * Composes the first level, unless its colours are those of before, and puts the tile together.
     *
     * @param film the colours of before
     * @param fine whether the rows are finer samples, whose colours only accuracy ratio keeps, to bound its errors
     */
    private CachedTile finish(SamplePlaces places, TileLevel top, LowerLevels.Kept below, boolean same, float[][] film, EdgeCodes codes,
            boolean fine) {
        TileLevel[] levels = below.levels().clone();
        levels[0] = top;
        boolean kept = !fine || !job.options().accuracy().isExact();
        if (!same) {
            colors = kept ? new float[3][Film.TILE_PIXELS] : samples();
            eye.composer.background(top.rows(), job.scene(), places, colors);
            levels[0] = eye.compose(top, job.top(), below.images(), colors);
            filmBytes += kept ? 12L * Film.TILE_PIXELS : 0;
        }
        recolored = !same;
        return new CachedTile(levels, below.hitShapes(), below.images(), !kept ? null : same ? film : colors, codes);
    }

    private float[][] samples() {
        samples = samples == null ? new float[3][Film.TILE_PIXELS] : samples;
        return samples;
    }

    /**
     * @param order what became of the first level's rows; null if they are what they were
     * @param coded whether anti-aliasing wants to see the levels below
     */
    private LowerLevels.Kept updateLower(CachedTile old, TileLevel top, RowSplice order, boolean coded) {
        if (top.rows().reflective == 0) {
            return new LowerLevels.Kept(new TileLevel[] {top}, new int[0][], null);
        }
        return lower().updated(old, top, order, coded ? coder : null);
    }
}
