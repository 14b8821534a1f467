package lightning.render.gather;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.render.gather.point.Barriers;
import lightning.render.gather.point.NearPoints;
import lightning.render.gather.reflection.ReflectionGroup;
import lightning.render.gather.reflection.ReflectionPaths;
import lightning.render.gather.reflection.ReflectionPoints;
import lightning.render.gather.reflection.ReflectionWeight;
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
    private final BestPoints best;
    private final int[] order = new int[MAX_ROWS];
    private final float[] mirrored = new float[3];

    ReflectionWeigher(GatherStructure structure, ReflectionPaths paths) {
        this.structure = structure;
        this.paths = paths;
        best = new BestPoints(paths.count());
    }

    /** Returns the weights of up to 1024 rows. */
    RowWeights weigh(HitRows rows) {
        best.startRows();
        short[] index = new short[BEST * rows.count];
        byte[] weight = new byte[BEST * rows.count];
        for (int run = 0; run < rows.runCount; run++) {
            ReflectionGroup group = paths.group(rows.runMaterial[run]);
            if (group != null && group.count() > 0) {
                weigh(rows, rows.runStart(run), rows.runEnd[run], rows.runMaterial[run], group, index, weight);
            }
        }
        return new RowWeights(structure, best.used(), index, weight, null);
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
        best.startPlace();
        float roughness = ReflectionGroup.roughness(group.material, rows, row);
        boolean isAnisotropic = group.material.isAnisotropic();
        ReflectionPoints.mirror(rows.nx[row], rows.ny[row], rows.nz[row], rows.vx[row], rows.vy[row], rows.vz[row], mirrored);
        for (int i = 0; i < count; i++) {
            int p = its.point(its.near[i]);
            float w = ReflectionWeight.at(group, p, group.radius[p], rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row],
                    rows.nz[row], mirrored[0], mirrored[1], mirrored[2], roughness);
            if (isAnisotropic && w > 0) {
                w *= alignment(rows, row, group, p);
            }
            if (best.isAmong(w)) {
                best.insert(p, w);
            }
        }
    }

    private static float alignment(HitRows rows, int row, ReflectionGroup group, int p) {
        return rows.tangentX == null ? 1
                : group.alignment(p, rows.tangentX[row], requireNonNull(rows.tangentY)[row], requireNonNull(rows.tangentZ)[row]);
    }

    private void write(HitRows rows, int row, int material, ReflectionGroup group, short[] index, byte[] weight) {
        if (best.isEmpty()) {
            lastNearest[material] = group.groups.nearest(Barriers.NONE, rows.px[row], rows.py[row], rows.pz[row], rows.nx[row],
                    rows.ny[row], rows.nz[row], lastNearest[material]);
            best.writeOnly(row, group.number[lastNearest[material]], index, weight);
        } else {
            best.write(row, group.surface, group.radius, group.number, rows.px[row], rows.py[row], rows.pz[row], rows.nx[row], rows.ny[row],
                    rows.nz[row], index, weight);
        }
    }
}
