package lightning.render.relight.tile;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import lightning.render.cache.CachedTile;
import lightning.render.cache.TileLevel;
import lightning.render.relight.paper.HitShapes;
import lightning.render.shading.EdgeCoder;
import lightning.render.shading.Images;
import lightning.render.trace.Bounce;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowSplice;
import lightning.render.trace.TileVisibility;

/**
 * The levels of a tile below the first: what is seen in mirrors and through clear surfaces. They are a tree, for from a row of a clear
 * material a ray goes on in two ways; they are kept in a list, a level before those that are seen from it, what is mirrored before what is
 * refracted. Traced, updated and composed for one tile after the other: one for each thread.
 */
final class LowerLevels {
    private static final TileLevel[] NONE = {};

    private final Job job;
    private final LevelWorker worker;
    private final List<TileLevel> levels = new ArrayList<>();
    /** Where rows are not kept, the shapes that rays hit. */
    private final HitShapes hitShapes = new HitShapes();
    /** Tells anti-aliasing what is seen; null where it does not look. */
    private EdgeCoder coder;
    /** The levels before, and the next of them to be looked at. */
    private TileLevel[] old;
    private int next;
    private boolean changed;
    private long mirroredRays;

    LowerLevels(Job job, LevelWorker worker) {
        this.job = job;
        this.worker = worker;
    }

    /** The rays that went on from rows since the start, in either way. */
    long rays() {
        return mirroredRays;
    }

    /**
     * What a tile keeps of them.
     *
     * @param levels all levels; only the first where the others are kept as hit shapes
     * @param images what the rays bring that go on from the first level's rows; null where none does
     */
    record Kept(TileLevel[] levels, int[][] hitShapes, Images images) {}

    private void begin(TileLevel top, TileLevel[] before, int[][] shapes, EdgeCoder with) {
        levels.clear();
        levels.add(top);
        hitShapes.begin(shapes);
        coder = with;
        old = before;
        next = 1;
        changed = false;
    }

    /**
     * Traces them.
     *
     * @param top   the first level
     * @param shapes the shapes that their rays hit, as far as known
     * @param with  is told what is seen; null where anti-aliasing does not look
     */
    Kept traced(TileLevel top, int[][] shapes, EdgeCoder with) {
        begin(top, NONE, shapes, with);
        trace(top.rows(), 0, 0);
        if (job.progress().isCancelled()) {
            return new Kept(new TileLevel[] {top}, shapes, null);
        }
        Images images = images();
        return job.keepsRows() ? new Kept(levels.toArray(TileLevel[]::new), HitShapes.NONE, images)
                : new Kept(new TileLevel[] {top}, hitShapes.list(), images);
    }

    /**
     * Updates them. Of those that are kept as rows what is known stays, and rays are cast for the rest alone; others are traced from
     * the shapes that their rays hit.
     *
     * @param before the tile
     * @param top    its first level now
     * @param order  what became of that level's rows; null if they are what they were
     * @param with   is told what is seen; null where anti-aliasing does not look
     */
    Kept updated(CachedTile before, TileLevel top, RowSplice order, EdgeCoder with) {
        if (!job.keepsRows()) {
            return traced(top, order == null ? HitShapes.after(before.hitShapes, job.plan(), job.mirrored().geometry()) : HitShapes.NONE,
                    with);
        }
        begin(top, before.levels, HitShapes.NONE, with);
        changed = order != null || job.mirrors() != null && job.mirrors().compose();
        update(top.rows(), order, before.levels[0].rows(), 0, 0);
        return job.progress().isCancelled() ? new Kept(before.levels, before.hitShapes, null)
                : new Kept(levels.toArray(TileLevel[]::new), before.hitShapes, changed ? images() : before.images);
    }

    /** Traces all that is seen from a level's rows. */
    private void trace(HitRows rows, int depth, int place) {
        for (Bounce bounce : Bounce.values()) {
            if (depth < job.depth() && bounce.rows(rows) > 0 && !job.progress().isCancelled()) {
                trace(rows, bounce, depth, place);
            }
        }
    }

    private void trace(HitRows rows, Bounce bounce, int depth, int place) {
        if (hitShapes.hasNext() && !worker.visibility().touching(rows, bounce, job.shapes().seen()).isEmpty()) {
            // What is seen from these rows may be other rows, and then nothing is known of what is seen from theirs.
            hitShapes.dropRest();
        }
        int[] shapes = hitShapes.next();
        HitRows seen = worker.visibility().seenFrom(rows, bounce, shapes, allocator(rows));
        mirroredRays += worker.visibility().rays();
        if (!job.keepsRows()) {
            hitShapes.add(shapes == null ? worker.visibility().hitShapes() : shapes);
        }
        TileLevel level = worker.lit(seen);
        int seenPlace = EdgeCoder.place(place, bounce);
        add(level, depth + 1, seenPlace);
        trace(level.rows(), depth + 1, seenPlace);
    }

    private void add(TileLevel level, int depth, int place) {
        levels.add(level);
        if (coder != null && !job.progress().isCancelled()) {
            worker.code(coder, depth, place, level);
        }
    }

    private TileVisibility.Allocator allocator(HitRows above) {
        return (count, textured, clear) -> new HitRows(count, textured, clear, above.code != null, job.owned());
    }

    /**
     * Updates all that is seen from a level's rows.
     *
     * @param order  what became of the level's rows; null if they are what they were
     * @param before the level's rows before
     */
    private void update(HitRows rows, RowSplice order, HitRows before, int depth, int place) {
        for (Bounce bounce : Bounce.values()) {
            boolean had = depth < job.depthBefore() && bounce.rows(before) > 0;
            boolean has = depth < job.depth() && bounce.rows(rows) > 0;
            if (job.progress().isCancelled()) {
                return;
            }
            if (had && has) {
                BitSet anew = worker.visibility().touching(rows, bounce, job.shapes().seen());
                if (LevelWorker.areFew(anew, bounce.rows(rows))) {
                    update(rows, bounce, order, anew, depth, place);
                    continue;
                }
            }
            changed |= had || has;
            if (had) {
                skip(depth + 1);
            }
            if (has) {
                trace(rows, bounce, depth, place);
            }
        }
    }

    /** Goes past an old level and all that was seen from it. */
    private void skip(int depth) {
        HitRows rows = old[next++].rows();
        for (Bounce bounce : Bounce.values()) {
            if (depth < job.depthBefore() && bounce.rows(rows) > 0) {
                skip(depth + 1);
            }
        }
    }

    /** @param anew those of the rows whose rays may hit something else than before */
    private void update(HitRows rows, Bounce bounce, RowSplice order, BitSet anew, int depth, int place) {
        TileLevel before = old[next++];
        RowSplice here = !anew.isEmpty() || moves(order, before.rows())
                ? RowSplice.seenFrom(order, bounce.rows(rows), before.rows(), anew, job.mirrored().geometry().materials()) : null;
        TileLevel kept = here == null ? before : worker.sorted(here, before);
        if (job.mirrors() != null) {
            TileLevel textured = worker.retextured(kept, rows, bounce, job.mirrors());
            TileLevel updated = worker.updated(textured, job.mirrors());
            if (job.progress().isCancelled()) {
                return;
            }
            changed |= job.mirrors().recolors(textured, updated.layers());
            kept = updated;
        }
        BitSet unknown = order == null ? new BitSet() : order.unfollowed(bounce);
        unknown.or(anew);
        if (!unknown.isEmpty()) {
            TileLevel added = worker.lit(worker.visibility().seenFromSome(rows, bounce, unknown, allocator(rows)));
            mirroredRays += worker.visibility().rays();
            RowSplice all = RowSplice.joined(bounce.rows(rows), kept.rows(), added.rows(), job.mirrored().geometry().materials());
            kept = worker.joined(all, kept, added);
            here = here == null ? all : here.then(all);
        }
        int seenPlace = EdgeCoder.place(place, bounce);
        add(kept, depth + 1, seenPlace);
        changed |= here != null;
        update(kept.rows(), here, before.rows(), depth + 1, seenPlace);
    }

    /** Whether rows that are seen from others change their places, or are seen no more. */
    private boolean moves(RowSplice above, HitRows rows) {
        return above != null || job.mirrors() != null && job.mirrors().materials().mirrors().isIn(rows);
    }

    /** Composes all of them; what the rays bring that go on from the first level's rows. */
    private Images images() {
        next = 1;
        Images images = images(levels.getFirst().rows(), 0);
        return images == null ? null : images.compact(levels.getFirst().rows());
    }

    private Images images(HitRows rows, int depth) {
        if (depth == job.depth() || rows.reflective == 0) {
            return worker.composer.unfollowed(rows, depth);
        }
        Images images = worker.composer.followed(rows, job.mirrored().scene().world(), depth);
        for (Bounce bounce : Bounce.values()) {
            if (bounce.rows(rows) > 0) {
                int at = next++;
                Images below = images(levels.get(at).rows(), depth + 1);
                levels.set(at, worker.compose(levels.get(at), job.keepsRows() ? job.mirrors() : null, below, images.of(bounce)));
            }
        }
        return images;
    }

    /**
     * Asks again what all rays hit that go on from the rows of a tile as it was; of each level something follows.
     *
     * @param top the first level, of which it follows already
     */
    TileLevel[] asked(CachedTile tile, TileLevel top, boolean coded, Answer answer) {
        begin(top, tile.levels, HitShapes.NONE, null);
        ask(top.rows(), 0, coded, answer);
        return levels.toArray(TileLevel[]::new);
    }

    /** What follows from rows that were traced again, for a level whose rows they are, perhaps in another order. */
    @FunctionalInterface
    interface Answer {
        TileLevel of(TileLevel level, HitRows again);
    }

    private void ask(HitRows rows, int depth, boolean coded, Answer answer) {
        for (Bounce bounce : Bounce.values()) {
            if (depth < job.depthBefore() && bounce.rows(rows) > 0 && next < old.length) {
                HitRows again = worker.visibility().seenFrom(rows, bounce, null,
                        (count, textured, clear) -> new HitRows(count, textured, clear, coded, job.owned()));
                mirroredRays += worker.visibility().rays();
                TileLevel level = answer.of(old[next++], again);
                levels.add(level);
                ask(level.rows(), depth + 1, coded, answer);
            }
        }
    }
}
