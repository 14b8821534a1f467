package lightning.render.gather.rim;

import static java.util.Objects.requireNonNull;

import java.util.HashMap;
import java.util.Map;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.SurfaceColumns;
import lightning.render.gather.ray.RayLinks;

/**
 * Finds the cells of a gather point's grid of directions that contain the rim of an opening: among the rays in the same cell of the grid, of
 * other points nearby, some leave the scene and some do not. The point's own rays have no say, or the mean of its light would be
 * biased.
 *
 * <p>Nearby are all points in the same wide cell ({@link CellKeys#wideKey}), so that they need not be searched.
 */
public final class RimCells {
    private static final int BATCH = 1024;

    private final RayLinks links;
    private final long[] keys;
    private final Map<Long, Group> groups = new HashMap<>();

    /** Kinds of hits of the rays of a group, with a bit for each cell of the grid of directions. */
    private static final class Group {
        /** Cells in which the rays of one or more members, and of two or more, leave the scene. */
        private final long[] anyMiss;
        private final long[] moreMiss;
        /** Cells in which the rays of one or more members, and of two or more, hit a surface. */
        private final long[] anyHit;
        private final long[] moreHit;

        Group(int words) {
            anyMiss = new long[words];
            moreMiss = new long[words];
            anyHit = new long[words];
            moreHit = new long[words];
        }

        void add(int word, long misses) {
            moreMiss[word] |= anyMiss[word] & misses;
            anyMiss[word] |= misses;
            moreHit[word] |= anyHit[word] & ~misses;
            anyHit[word] |= ~misses;
        }

        /** Returns the cells in which the rays of members other than one differ. */
        long rims(int word, long itsMisses) {
            return (moreMiss[word] | anyMiss[word] & ~itsMisses) & (moreHit[word] | anyHit[word] & itsMisses);
        }
    }

    /**
     * @param links what the rays of the points hit
     * @throws java.util.concurrent.CancellationException if the progress requested cancellation
     */
    public RimCells(CellKeys cellKeys, SurfaceColumns points, RayLinks links, WorkerPool workers, Progress progress) {
        this.links = links;
        keys = wideKeys(cellKeys, points, points.count, workers, progress);
        addAll(links, keys, workers, progress);
    }

    private static long[] wideKeys(CellKeys cellKeys, SurfaceColumns of, int count, WorkerPool workers, Progress progress) {
        long[] keys = new long[count];
        workers.run(Math.ceilDiv(count, BATCH), (_, job) -> {
            for (int p = job * BATCH; p < Math.min(count, job * BATCH + BATCH); p++) {
                keys[p] = cellKeys.wideKey(of.px[p], of.py[p], of.pz[p], of.nx[p], of.ny[p], of.nz[p]);
            }
        }, progress);
        return keys;
    }

    private void addAll(RayLinks rays, long[] itsKeys, WorkerPool workers, Progress progress) {
        int words = words(rays);
        long[] misses = new long[itsKeys.length * words];
        workers.run(Math.ceilDiv(itsKeys.length, BATCH), (_, job) -> {
            for (int i = job * BATCH * words; i < Math.min(misses.length, (job + 1) * BATCH * words); i++) {
                misses[i] = misses(rays, i / words, i % words);
            }
        }, progress);
        for (int i = 0; i < misses.length; i++) {
            groups.computeIfAbsent(itsKeys[i / words], _ -> new Group(words)).add(i % words, misses[i]);
        }
    }

    private static int words(RayLinks rays) {
        return Math.ceilDiv(rays.raysPerPoint(), Long.SIZE);
    }

    /** Returns the rays of a point in one word that leave the scene. */
    private static long misses(RayLinks rays, int p, int word) {
        long misses = 0;
        for (int k = word * Long.SIZE; k < Math.min(rays.raysPerPoint(), (word + 1) * Long.SIZE); k++) {
            misses |= rays.surfel(p * rays.raysPerPoint() + k) == RayLinks.MISS ? 1L << k : 0;
        }
        return misses;
    }

    /**
     * Writes the cells of a point's grid that contain a rim, ascending.
     *
     * @param to as long as the point has rays
     * @return their number
     */
    public int find(int p, char[] to) {
        Group group = requireNonNull(groups.get(keys[p]));
        int count = 0;
        for (int word = 0; word < words(links); word++) {
            for (long left = group.rims(word, misses(links, p, word)); left != 0; left &= left - 1) {
                to[count++] = (char) (word * Long.SIZE + Long.numberOfTrailingZeros(left));
            }
        }
        return count;
    }
}
