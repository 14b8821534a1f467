package lightning.render.gather;

import java.util.Arrays;
import lightning.render.trace.HitRows;
import org.jspecify.annotations.Nullable;

/** Finds the reflection points of rows. Holds scratch memory: use one instance per thread. */
final class ReflectionWeigher {
    private static final int BEST = RowWeights.PER_ROW;
    private static final int MAX_ROWS = 1024;

    private final GatherStructure structure;
    private final ReflectionPaths paths;
    /** By material, created on first use. */
    private @Nullable NearPoints[] near = {};
    private int[] lastNearest = {};
    private final int[] used = new int[BEST * MAX_ROWS];
    private int usedCount;
    private final int[] indexOf;
    private final int[] usedBy;
    private int call;
    private final int[] order = new int[MAX_ROWS];
    private final int[] best = new int[BEST + 1];
    private final float[] bestWeight = new float[BEST + 1];
    private final LinearWeights linear = new LinearWeights();
    private final float[] mirrored = new float[3];

    ReflectionWeigher(GatherStructure structure, ReflectionPaths paths) {
        this.structure = structure;
        this.paths = paths;
        indexOf = new int[paths.count()];
        usedBy = new int[paths.count()];
    }

    /** Returns the weights of up to 1024 rows. */
    RowWeights weigh(HitRows rows) {
        call++;
        usedCount = 0;
        short[] index = new short[BEST * rows.count];
        byte[] weight = new byte[BEST * rows.count];
        for (int run = 0; run < rows.runCount; run++) {
            ReflectionGroup group = paths.group(rows.runMaterial[run]);
            if (group != null && group.count() > 0) {
                weigh(rows, rows.runStart(run), rows.runEnd[run], rows.runMaterial[run], group, index, weight);
            }
        }
        return new RowWeights(structure, Arrays.copyOf(used, usedCount), index, weight, null);
    }

    private void weigh(HitRows rows, int from, int to, int material, ReflectionGroup group, short[] index, byte[] weight) {
        for (int row = from; row < to; row++) {
            order[row] = row;
        }
        near(material, group).find(rows.px, rows.py, rows.pz, order, from, to, (row, candidates) -> {
            findBest(rows, row, group, near(material, group), candidates);
            write(rows, row, material, group, index, weight);
        });
    }

    private NearPoints near(int material, ReflectionGroup group) {
        if (material >= near.length) {
            near = Arrays.copyOf(near, material + 1);
            lastNearest = Arrays.copyOf(lastNearest, material + 1);
        }
        NearPoints its = near[material] == null ? new NearPoints(group.surface, group.radius, group.groups) : near[material];
        near[material] = its;
        return its;
    }

    private void findBest(HitRows rows, int row, ReflectionGroup group, NearPoints its, int count) {
        Arrays.fill(bestWeight, 0);
        float roughness = group.roughness(rows, row);
        ReflectionPoints.mirror(rows.nx[row], rows.ny[row], rows.nz[row], rows.vx[row], rows.vy[row], rows.vz[row], mirrored);
        for (int i = 0; i < count; i++) {
            int p = its.point(its.near[i]);
            float w = ReflectionWeight.at(group, p, group.radius[p], rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row],
                    rows.nz[row], mirrored[0], mirrored[1], mirrored[2], roughness);
            if (w > bestWeight[BEST]) {
                insert(p, w);
            }
        }
    }

    /** Inserts a point among the best, after those of equal weight. */
    private void insert(int p, float w) {
        int at = BEST;
        while (at > 0 && bestWeight[at - 1] < w) {
            bestWeight[at] = bestWeight[at - 1];
            best[at] = best[at - 1];
            at--;
        }
        bestWeight[at] = w;
        best[at] = p;
    }

    private void write(HitRows rows, int row, int material, ReflectionGroup group, short[] index, byte[] weight) {
        int at = BEST * row;
        if (bestWeight[0] == 0) {
            lastNearest[material] = group.groups.nearest(Barriers.NONE, rows.px[row], rows.py[row], rows.pz[row], rows.nx[row],
                    rows.ny[row], rows.nz[row], lastNearest[material]);
            index[at] = index(group.number[lastNearest[material]]);
            weight[at] = (byte) WeightedPoints.MAX_WEIGHT;
            return;
        }
        adjust(rows, row, group);
        float scale = WeightedPoints.MAX_WEIGHT / linear.largest();
        for (int i = 0; i < linear.count(); i++) {
            int w = WeightedPoints.whole(linear.weight(i), scale);
            if (w > 0) {
                index[at] = index(group.number[best[i]]);
                weight[at++] = (byte) w;
            }
        }
    }

    private void adjust(HitRows rows, int row, ReflectionGroup group) {
        linear.start(rows.nx[row], rows.ny[row], rows.nz[row], group.radius[best[0]]);
        for (int i = 0; i < BEST && bestWeight[i] > 0; i++) {
            // The weight of the next point is subtracted, so that nothing jumps where it replaces another.
            float w = bestWeight[0] > bestWeight[BEST] ? bestWeight[i] - bestWeight[BEST] : 1;
            int p = best[i];
            linear.add(w, group.surface.px[p] - rows.px[row], group.surface.py[p] - rows.py[row], group.surface.pz[p] - rows.pz[row]);
        }
        linear.adjust();
    }

    private short index(int p) {
        if (usedBy[p] != call) {
            usedBy[p] = call;
            indexOf[p] = usedCount;
            used[usedCount++] = p;
        }
        return (short) indexOf[p];
    }
}
